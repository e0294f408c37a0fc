//! The crate `ethercrab-wire`: derived for a PDO.

use ethercrab_wire::{EtherCrabWireRead as _, EtherCrabWireReadWrite, EtherCrabWireWrite as _};

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

macro_rules! ethercrab {
    (
        $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        #[derive(EtherCrabWireReadWrite)]
        #[wire(bytes = $size)]
        pub struct $pdo {
            $(
                #[wire(bytes = $length)]
                $field: $type,
            )*
        }

        values!($image = [$pdo; $count]: $($field)*);

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = {
                extern "C-unwind" fn pack(pdos: &$image, frame: &mut [u8; $bytes]) {
                    for (chunk, pdo) in frame.chunks_exact_mut($size).zip(pdos) {
                        pdo.pack_to_slice_unchecked(chunk);
                    }
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                extern "C-unwind" fn unpack(frame: &[u8; $bytes], pdos: &mut $image) {
                    for (chunk, pdo) in frame.chunks_exact($size).zip(pdos) {
                        *pdo = $pdo::unpack_from_slice(chunk).unwrap();
                    }
                }
                unpack
            };
        }
    };
}

images!(ethercrab);
