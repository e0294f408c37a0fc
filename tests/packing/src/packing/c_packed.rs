//! C: a struct that has the layout of the frame, filled and read field by field. See `images.c`.

use super::images::images;
use super::{Image, Pack, Unpack};

macro_rules! c_packed {
    (
        $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        #[repr(C)]
        pub struct $pdo {
            $($field: $type,)*
        }

        pub type $image = [$pdo; $count];

        impl Image<$bytes> for $image {
            const ZERO: Self = [const { $pdo { $($field: 0,)* } }; $count];
            const PACK: Pack<Self, $bytes> = {
                unsafe extern "C-unwind" {
                    #[link_name = concat!("place_", stringify!($image))]
                    safe fn pack(pdos: &$image, frame: &mut [u8; $bytes]);
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                unsafe extern "C-unwind" {
                    #[link_name = concat!("fetch_", stringify!($image))]
                    safe fn unpack(frame: &[u8; $bytes], pdos: &mut $image);
                }
                unpack
            };

            fn fields(&self) -> Vec<i64> {
                self.iter().flat_map(|pdo| [$(pdo.$field.into()),*]).collect()
            }
        }
    };
}

images!(c_packed);
