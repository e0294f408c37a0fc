//! The crate `deku`: derived, to and from a slice.

use deku::prelude::*;

use super::images::images;
use super::{Image, Pack, Unpack, Values};

macro_rules! structs {
    (
        $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        #[derive(DekuRead, DekuWrite)]
        #[deku(endian = "little")]
        pub struct $pdo {
            $($field: $type,)*
        }

        #[derive(DekuRead, DekuWrite)]
        pub struct $image {
            pdos: [$pdo; $count],
        }

        impl Values for $image {
            const ZERO: Self = Self { pdos: [const { $pdo { $($field: 0,)* } }; $count] };

            fn fields(&self) -> Vec<i64> {
                self.pdos.iter().flat_map(|pdo| [$(pdo.$field.into()),*]).collect()
            }
        }

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = {
                extern "C-unwind" fn pack(image: &$image, frame: &mut [u8; $bytes]) {
                    image.to_slice(frame).unwrap();
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                extern "C-unwind" fn unpack(frame: &[u8; $bytes], image: &mut $image) {
                    *image = $image::from_bytes((frame, 0)).unwrap().1;
                }
                unpack
            };
        }
    };
}

images!(structs);
