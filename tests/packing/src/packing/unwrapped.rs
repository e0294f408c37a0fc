//! By hand, as is often seen: a slice, an offset that runs along, and an `unwrap` for each field.

use super::{INPUTS, In, OUTPUTS, Out};

pub use super::c::{inputs, outputs};

fn put(frame: &mut [u8], offset: &mut usize, bytes: &[u8]) {
    frame[*offset..*offset + bytes.len()].copy_from_slice(bytes);
    *offset += bytes.len();
}

fn get<const N: usize>(frame: &[u8], offset: &mut usize) -> [u8; N] {
    let bytes = frame[*offset..*offset + N].try_into().unwrap();
    *offset += N;
    bytes
}

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    pack_outputs_into(axes, frame);
}

fn pack_outputs_into(axes: &[Out], frame: &mut [u8]) {
    let mut offset = 0;
    for axis in axes {
        put(frame, &mut offset, &axis.controlword.to_le_bytes());
        put(frame, &mut offset, &axis.mode.to_le_bytes());
        put(frame, &mut offset, &axis.position.to_le_bytes());
    }
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    let mut offset = 0;
    for axis in axes {
        axis.controlword = u16::from_le_bytes(get(frame, &mut offset));
        axis.mode = i8::from_le_bytes(get(frame, &mut offset));
        axis.position = i32::from_le_bytes(get(frame, &mut offset));
    }
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    let mut offset = 0;
    for axis in axes {
        put(frame, &mut offset, &axis.statusword.to_le_bytes());
        put(frame, &mut offset, &axis.mode.to_le_bytes());
        put(frame, &mut offset, &axis.position.to_le_bytes());
        put(frame, &mut offset, &axis.following_error.to_le_bytes());
    }
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    let mut offset = 0;
    for axis in axes {
        axis.statusword = u16::from_le_bytes(get(frame, &mut offset));
        axis.mode = i8::from_le_bytes(get(frame, &mut offset));
        axis.position = i32::from_le_bytes(get(frame, &mut offset));
        axis.following_error = i32::from_le_bytes(get(frame, &mut offset));
    }
}
