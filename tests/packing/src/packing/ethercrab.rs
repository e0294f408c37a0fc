//! The crate `ethercrab-wire`: derived for a struct of an axis.

use ethercrab_wire::{EtherCrabWireRead as _, EtherCrabWireReadWrite, EtherCrabWireWrite as _};

use super::{INPUTS, OUTPUTS};

#[derive(Debug, Clone, Copy, EtherCrabWireReadWrite)]
#[wire(bytes = 7)]
pub struct Out {
    #[wire(bytes = 2)]
    controlword: u16,
    #[wire(bytes = 1)]
    mode: i8,
    #[wire(bytes = 4)]
    position: i32,
}

#[derive(Debug, Clone, Copy, EtherCrabWireReadWrite)]
#[wire(bytes = 11)]
pub struct In {
    #[wire(bytes = 2)]
    statusword: u16,
    #[wire(bytes = 1)]
    mode: i8,
    #[wire(bytes = 4)]
    position: i32,
    #[wire(bytes = 4)]
    following_error: i32,
}

pub fn outputs() -> [Out; 6] {
    [Out { controlword: 6, mode: 8, position: -1 }; 6]
}

pub fn inputs() -> [In; 6] {
    [In { statusword: 0x0237, mode: 8, position: -1, following_error: 3 }; 6]
}

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    for (axis, bytes) in axes.iter().zip(frame.chunks_exact_mut(7)) {
        axis.pack_to_slice_unchecked(bytes);
    }
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    for (axis, bytes) in axes.iter_mut().zip(frame.chunks_exact(7)) {
        *axis = Out::unpack_from_slice(bytes).unwrap();
    }
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    for (axis, bytes) in axes.iter().zip(frame.chunks_exact_mut(11)) {
        axis.pack_to_slice_unchecked(bytes);
    }
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    for (axis, bytes) in axes.iter_mut().zip(frame.chunks_exact(11)) {
        *axis = In::unpack_from_slice(bytes).unwrap();
    }
}
