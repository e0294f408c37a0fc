//! Nothing: what the call alone costs.

use super::images::images;
use super::{Image, Pack, Unpack, Values};

macro_rules! nothing {
    ($image:ident, $bytes:literal = $pdos:tt: $($fields:tt)*) => {
        pub struct $image;

        impl Values for $image {
            const ZERO: Self = Self;

            fn fields(&self) -> Vec<i64> {
                Vec::new()
            }
        }

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = pack;
            const UNPACK: Unpack<Self, $bytes> = unpack;
        }
    };
}

images!(nothing);

extern "C-unwind" fn pack<V, const N: usize>(_: &V, _: &mut [u8; N]) {}

extern "C-unwind" fn unpack<V, const N: usize>(_: &[u8; N], _: &mut V) {}
