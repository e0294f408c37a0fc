//! Generated: views of the frame, each field from or to a place of the program's own.

use devc_runtime::pdo::InPlace;

use super::{INPUTS, In, OUTPUTS, Out};
use crate::c887::{Controlword, Inputs, Outputs, Statusword};

pub use super::c::{inputs, outputs};

pub fn pack_outputs(axes: &[Out; 6], frame: &mut [u8; OUTPUTS]) {
    for (mut view, axis) in Outputs::view(frame).axes_mut().into_iter().zip(axes) {
        view.set_controlword(Controlword(axis.controlword));
        view.set_modes_of_operation(axis.mode);
        view.set_target_position(axis.position);
    }
}

pub fn unpack_outputs(frame: &[u8; OUTPUTS], axes: &mut [Out; 6]) {
    for (view, axis) in Outputs::view(frame).axes().into_iter().zip(axes) {
        axis.controlword = view.controlword().0;
        axis.mode = view.modes_of_operation();
        axis.position = view.target_position();
    }
}

pub fn pack_inputs(axes: &[In; 6], frame: &mut [u8; INPUTS]) {
    for (mut view, axis) in Inputs::view(frame).axes_mut().into_iter().zip(axes) {
        view.set_statusword(Statusword(axis.statusword));
        view.set_modes_of_operation_display(axis.mode);
        view.set_position_actual_value(axis.position);
        view.set_following_error_actual_value(axis.following_error);
    }
}

pub fn unpack_inputs(frame: &[u8; INPUTS], axes: &mut [In; 6]) {
    for (view, axis) in Inputs::view(frame).axes().into_iter().zip(axes) {
        axis.statusword = view.statusword().0;
        axis.mode = view.modes_of_operation_display();
        axis.position = view.position_actual_value();
        axis.following_error = view.following_error_actual_value();
    }
}
