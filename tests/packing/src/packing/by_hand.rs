//! By hand, as careful as can be: constant offsets into an array.

use super::{INPUTS, In, OUTPUTS, Out};

pub use super::c::{inputs, outputs};

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    let (chunks, _) = frame.as_chunks_mut::<7>();
    for (chunk, axis) in chunks.iter_mut().zip(axes) {
        chunk[0..2].copy_from_slice(&axis.controlword.to_le_bytes());
        chunk[2..3].copy_from_slice(&axis.mode.to_le_bytes());
        chunk[3..7].copy_from_slice(&axis.position.to_le_bytes());
    }
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    let (chunks, _) = frame.as_chunks::<7>();
    for (chunk, axis) in chunks.iter().zip(axes) {
        let [c0, c1, m, p0, p1, p2, p3] = *chunk;
        axis.controlword = u16::from_le_bytes([c0, c1]);
        axis.mode = i8::from_le_bytes([m]);
        axis.position = i32::from_le_bytes([p0, p1, p2, p3]);
    }
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    let (chunks, _) = frame.as_chunks_mut::<11>();
    for (chunk, axis) in chunks.iter_mut().zip(axes) {
        chunk[0..2].copy_from_slice(&axis.statusword.to_le_bytes());
        chunk[2..3].copy_from_slice(&axis.mode.to_le_bytes());
        chunk[3..7].copy_from_slice(&axis.position.to_le_bytes());
        chunk[7..11].copy_from_slice(&axis.following_error.to_le_bytes());
    }
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    let (chunks, _) = frame.as_chunks::<11>();
    for (chunk, axis) in chunks.iter().zip(axes) {
        let [s0, s1, m, p0, p1, p2, p3, e0, e1, e2, e3] = *chunk;
        axis.statusword = u16::from_le_bytes([s0, s1]);
        axis.mode = i8::from_le_bytes([m]);
        axis.position = i32::from_le_bytes([p0, p1, p2, p3]);
        axis.following_error = i32::from_le_bytes([e0, e1, e2, e3]);
    }
}
