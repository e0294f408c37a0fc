//! By hand, as careful as can be: constant offsets into an array.

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

macro_rules! by_hand {
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
                    let (chunks, _) = frame.as_chunks_mut::<$size>();
                    for (chunk, pdo) in chunks.iter_mut().zip(pdos) {
                        $(chunk[$first..$first + $length].copy_from_slice(&pdo.$field.to_le_bytes());)*
                    }
                }
                pack
            };
            const UNPACK: Unpack<Self, $bytes> = {
                extern "C-unwind" fn unpack(frame: &[u8; $bytes], pdos: &mut $image) {
                    let (chunks, _) = frame.as_chunks::<$size>();
                    for (chunk, pdo) in chunks.iter().zip(pdos) {
                        $(
                            let bytes = chunk[$first..$first + $length].try_into().unwrap();
                            pdo.$field = $type::from_le_bytes(bytes);
                        )*
                    }
                }
                unpack
            };
        }
    };
}

images!(by_hand);
