//! Generated: structs by value.

use super::{INPUTS, OUTPUTS};
use crate::c887::{Inputs, Outputs};

pub fn outputs() -> Outputs {
    Outputs::unpack([1; OUTPUTS])
}

pub fn inputs() -> Inputs {
    Inputs::unpack([1; INPUTS])
}

pub fn pack_outputs(outputs: &Outputs, frame: &mut [u8; OUTPUTS]) {
    *frame = outputs.pack();
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], outputs: &mut Outputs) {
    *outputs = Outputs::unpack(*frame);
}

pub fn pack_inputs(inputs: &Inputs, frame: &mut [u8; INPUTS]) {
    *frame = inputs.pack();
}

pub fn unpack_inputs(frame: &[u8; INPUTS], inputs: &mut Inputs) {
    *inputs = Inputs::unpack(*frame);
}
