//! The crate `deku`: derived, to and from a slice.

use deku::prelude::*;

use super::{INPUTS, OUTPUTS};

#[derive(Debug, Clone, Copy, DekuRead, DekuWrite)]
#[deku(endian = "little")]
pub struct Out {
    controlword: u16,
    mode: i8,
    position: i32,
}

#[derive(Debug, Clone, Copy, DekuRead, DekuWrite)]
#[deku(endian = "little")]
pub struct In {
    statusword: u16,
    mode: i8,
    position: i32,
    following_error: i32,
}

#[derive(Debug, DekuRead, DekuWrite)]
pub struct Outputs {
    axes: [Out; 6],
}

#[derive(Debug, DekuRead, DekuWrite)]
pub struct Inputs {
    axes: [In; 6],
}

pub fn outputs() -> Outputs {
    Outputs { axes: [Out { controlword: 6, mode: 8, position: -1 }; 6] }
}

pub fn inputs() -> Inputs {
    Inputs { axes: [In { statusword: 0x0237, mode: 8, position: -1, following_error: 3 }; 6] }
}

pub fn pack_outputs(outputs: &Outputs, frame: &mut [u8; OUTPUTS]) {
    outputs.to_slice(frame).unwrap();
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], outputs: &mut Outputs) {
    *outputs = Outputs::from_bytes((frame, 0)).unwrap().1;
}

pub fn pack_inputs(inputs: &Inputs, frame: &mut [u8; INPUTS]) {
    inputs.to_slice(frame).unwrap();
}

pub fn unpack_inputs(frame: &[u8; INPUTS], inputs: &mut Inputs) {
    *inputs = Inputs::from_bytes((frame, 0)).unwrap().1;
}
