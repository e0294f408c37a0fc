//! Process data: by value, from slices, and in place.

use core::hint::black_box;

use devc_runtime::bytes::ByteArray;
use devc_runtime::pdo::{InPlace, ProcessData};

use crate::c887::{Controlword, Inputs, Outputs, RxPdo1600, RxPdo1601, Statusword, TxPdo1A00, TxPdo1A01};
use crate::pmc_sc6::double;
use crate::s700::s700::{DigitalIo, TxPdo1B0B};

pub fn run() {
    by_value::<Outputs>();
    by_value::<Inputs>();
    by_value::<RxPdo1600>();
    by_value::<RxPdo1601>();
    by_value::<TxPdo1A00>();
    by_value::<TxPdo1A01>();
    by_value::<TxPdo1B0B>();
    by_value::<double::Outputs>();
    by_value::<double::Inputs>();
    motion_tasks(black_box(&mut [0; 40]));
    double_axis(black_box(&mut [0; 58]));
    outputs(black_box(&mut [0; 42]));
    inputs(black_box(&mut [0; 66]));
}

/// The slices can have any length.
fn by_value<P: ProcessData>() {
    let value = P::unpack(black_box(<P::Image as ByteArray>::ZERO));
    black_box(value.pack());
    if let Ok(value) = P::unpack_from(black_box(&[0; 80])) {
        let _ = black_box(value.pack_into(black_box(&mut [0; 80])));
    }
}

fn outputs(frame: &mut [u8]) {
    let Ok(mut outputs) = Outputs::view_of_mut(frame) else { return };
    for mut axis in outputs.axes_mut() {
        axis.set_controlword(Controlword(black_box(6)).with_fault_reset(black_box(true)));
        axis.set_modes_of_operation(black_box(8));
        axis.set_target_position(black_box(axis.target_position()));
    }
}

fn inputs(frame: &mut [u8]) {
    let Ok(mut inputs) = Inputs::view_of_mut(frame) else { return };
    for axis in inputs.axes() {
        black_box((axis.statusword().state().is_ok(), axis.position_actual_value()));
    }
    for mut axis in inputs.axes_mut() {
        axis.set_statusword(Statusword(black_box(0x0237)));
    }
}

/// A PDO with a field that has fewer bits than its place in the frame.
fn motion_tasks(frame: &mut [u8]) {
    let Ok(mut inputs) = TxPdo1B0B::view_of_mut(frame) else { return };
    inputs.set_digital_io(DigitalIo(black_box(inputs.digital_io().0)));
    inputs.set_motion_task_status(black_box(inputs.motion_task_status()));
}

fn double_axis(frame: &mut [u8]) {
    let Ok(mut inputs) = double::Inputs::view_of_mut(frame) else { return };
    for mut axis in inputs.axes_mut() {
        axis.set_velocity_actual_value(black_box(axis.velocity_actual_value()));
        axis.set_torque_actual_value(black_box(axis.torque_actual_value()));
        axis.set_status_word_user_defined(black_box(axis.status_word_user_defined()));
    }
}
