//! The crate `zerocopy`: structs of bytes laid over the frame.

use zerocopy::little_endian::{I32, U16};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{INPUTS, In, OUTPUTS, Out};

pub use super::c::{inputs, outputs};

#[derive(FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct PackedOut {
    controlword: U16,
    mode: i8,
    position: I32,
}

#[derive(FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct PackedIn {
    statusword: U16,
    mode: i8,
    position: I32,
    following_error: I32,
}

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    for (packed, axis) in <[PackedOut; 6]>::mut_from_bytes(frame).unwrap().iter_mut().zip(axes) {
        packed.controlword.set(axis.controlword);
        packed.mode = axis.mode;
        packed.position.set(axis.position);
    }
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    for (packed, axis) in <[PackedOut; 6]>::ref_from_bytes(frame).unwrap().iter().zip(axes) {
        axis.controlword = packed.controlword.get();
        axis.mode = packed.mode;
        axis.position = packed.position.get();
    }
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    for (packed, axis) in <[PackedIn; 6]>::mut_from_bytes(frame).unwrap().iter_mut().zip(axes) {
        packed.statusword.set(axis.statusword);
        packed.mode = axis.mode;
        packed.position.set(axis.position);
        packed.following_error.set(axis.following_error);
    }
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    for (packed, axis) in <[PackedIn; 6]>::ref_from_bytes(frame).unwrap().iter().zip(axes) {
        axis.statusword = packed.statusword.get();
        axis.mode = packed.mode;
        axis.position = packed.position.get();
        axis.following_error = packed.following_error.get();
    }
}
