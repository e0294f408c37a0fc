//! C: functions that shift each field into its bytes. See `images.c`.

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

/// The functions whose names begin so, with the types that a macro names for the fields.
macro_rules! c {
    (
        $held:ident $pack:literal $unpack:literal $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        #[repr(C)]
        pub struct $pdo {
            $($field: $held!($field $type),)*
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

/// The type that a field has everywhere.
macro_rules! whole {
    ($field:ident $type:ty) => {
        $type
    };
}

pub(super) use {c, whole};

images!(c whole "pack_" "unpack_");
