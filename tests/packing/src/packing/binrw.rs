//! The crate `binrw`: derived, to and from a cursor.

use std::io::Cursor;

use binrw::{BinRead, BinWrite};

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

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

        values!($image = [$pdo; $count]: $($field)*);

        impl Image<$bytes> for $image {
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
        }
    };
}

images!(structs);
