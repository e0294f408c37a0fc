//! C: the generated header, of which each function is called once. See `generated.c`.

use super::c::c;
use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

/// The type that a field has in the header: of the digital inputs and outputs of the S700 there is but half.
macro_rules! held {
    (digital_io $type:ty) => {
        u16
    };
    ($field:ident $type:ty) => {
        $type
    };
}

images!(c held "generated_pack_" "generated_unpack_");
