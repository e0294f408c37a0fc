//! The crate `zerocopy`: structs of bytes laid over the frame.

use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

/// Numbers as bytes, by the names of the numbers.
#[allow(non_camel_case_types)]
mod bytes {
    pub use zerocopy::little_endian::{I16 as i16, I32 as i32, U16 as u16, U32 as u32};
    pub type i8 = core::primitive::i8;
}

macro_rules! zero_copy {
    (
        $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        pub struct $pdo {
            $($field: $type,)*
        }

        values!($image = [$pdo; $count]: $($field)*);

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = {
                extern "C-unwind" fn pack(pdos: &$image, frame: &mut [u8; $bytes]) {
                    let packed = <[packed::$pdo; $count]>::mut_from_bytes(frame).unwrap();
                    for (packed, pdo) in packed.iter_mut().zip(pdos) {
                        $(packed.$field = pdo.$field.into();)*
                    }
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                extern "C-unwind" fn unpack(frame: &[u8; $bytes], pdos: &mut $image) {
                    let packed = <[packed::$pdo; $count]>::ref_from_bytes(frame).unwrap();
                    for (packed, pdo) in packed.iter().zip(pdos) {
                        $(pdo.$field = packed.$field.into();)*
                    }
                }
                unpack
            };
        }
    };
}

images!(zero_copy);

/// What lies over the frame.
mod packed {
    use super::*;

    macro_rules! packed {
        (
            $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
            $($field:ident: $type:ident at $first:literal, $length:literal;)*
        ) => {
            #[derive(FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
            #[repr(C)]
            pub struct $pdo {
                $(pub $field: bytes::$type,)*
            }
        };
    }

    images!(packed);
}
