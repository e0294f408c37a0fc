//! By hand, as is often seen: a slice, an offset that runs along, and an `unwrap` for each field.

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

macro_rules! unwrapped {
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
                    let (frame, mut offset) = (frame.as_mut_slice(), 0);
                    for pdo in pdos {
                        $(put(frame, &mut offset, &pdo.$field.to_le_bytes());)*
                    }
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                extern "C-unwind" fn unpack(frame: &[u8; $bytes], pdos: &mut $image) {
                    let (frame, mut offset) = (frame.as_slice(), 0);
                    for pdo in pdos {
                        $(pdo.$field = $type::from_le_bytes(get(frame, &mut offset));)*
                    }
                }
                unpack
            };
        }
    };
}

images!(unwrapped);

fn put(frame: &mut [u8], offset: &mut usize, bytes: &[u8]) {
    frame[*offset..*offset + bytes.len()].copy_from_slice(bytes);
    *offset += bytes.len();
}

fn get<const N: usize>(frame: &[u8], offset: &mut usize) -> [u8; N] {
    let bytes = frame[*offset..*offset + N].try_into().unwrap();
    *offset += N;
    bytes
}
