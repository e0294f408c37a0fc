//! C: functions that shift each field into its bytes, and a packed struct laid over the frame. See `packing.c`.

use super::{INPUTS, In, OUTPUTS, Out};

unsafe extern "C" {
    fn c_pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]);
    fn c_unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]);
    fn c_pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]);
    fn c_unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]);
    fn c_place_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]);
    fn c_fetch_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]);
    fn c_place_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]);
    fn c_fetch_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]);
}

pub fn outputs() -> [Out; 6] {
    [Out { controlword: 6, mode: 8, position: -1 }; 6]
}

pub fn inputs() -> [In; 6] {
    [In { statusword: 0x0237, mode: 8, position: -1, following_error: 3 }; 6]
}

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    unsafe { c_pack_outputs(axes, frame) }
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    unsafe { c_unpack_outputs(frame, axes) }
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    unsafe { c_pack_inputs(axes, frame) }
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    unsafe { c_unpack_inputs(frame, axes) }
}

/// The struct has the layout of the frame.
pub mod packed {
    use super::{INPUTS, In, OUTPUTS, Out};

    pub use super::{inputs, outputs};

    pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
        unsafe { super::c_place_outputs(axes, frame) }
    }

    pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
        unsafe { super::c_fetch_outputs(frame, axes) }
    }

    pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
        unsafe { super::c_place_inputs(axes, frame) }
    }

    pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
        unsafe { super::c_fetch_inputs(frame, axes) }
    }
}
