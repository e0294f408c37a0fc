//! C: functions that shift each field into its bytes. See `images.c`.

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

/// The functions whose names begin so.
macro_rules! c {
    (
        $pack:literal $unpack:literal $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        #[repr(C)]
        pub struct $pdo {
            $($field: $type,)*
        }

        values!($image = [$pdo; $count]: $($field)*);

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = {
                unsafe extern "C-unwind" {
                    #[link_name = concat!($pack, stringify!($image))]
                    safe fn pack(pdos: &$image, frame: &mut [u8; $bytes]);
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                unsafe extern "C-unwind" {
                    #[link_name = concat!($unpack, stringify!($image))]
                    safe fn unpack(frame: &[u8; $bytes], pdos: &mut $image);
                }
                unpack
            };
        }
    };
}

pub(super) use c;

images!(c "pack_" "unpack_");
