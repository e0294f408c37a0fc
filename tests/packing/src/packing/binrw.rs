//! The crate `binrw`: derived, to and from a cursor.

use std::io::Cursor;

use binrw::{BinRead, BinWrite};

use super::images::images;
use super::{Image, Pack, Unpack};

macro_rules! structs {
    (
        $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        #[derive(BinRead, BinWrite)]
        #[brw(little)]
        pub struct $pdo {
            $($field: $type,)*
        }

        pub type $image = [$pdo; $count];

        impl Image<$bytes> for $image {
            const ZERO: Self = [const { $pdo { $($field: 0,)* } }; $count];
            const PACK: Pack<Self, $bytes> = {
                extern "C-unwind" fn pack(pdos: &$image, frame: &mut [u8; $bytes]) {
                    pdos.write_le(&mut Cursor::new(&mut frame[..])).unwrap();
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                extern "C-unwind" fn unpack(frame: &[u8; $bytes], pdos: &mut $image) {
                    *pdos = BinRead::read_le(&mut Cursor::new(&frame[..])).unwrap();
                }
                unpack
            };

            fn fields(&self) -> Vec<i64> {
                self.iter().flat_map(|pdo| [$(pdo.$field.into()),*]).collect()
            }
        }
    };
}

images!(structs);
