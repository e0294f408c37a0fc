//! Generated: views of the frame, each field from or to a place of the program's own.

use devc_runtime::pdo::InPlace;

use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};
use crate::{c887, pmc_sc6, s700};

macro_rules! in_place {
    (
        $image:ident, $bytes:literal = [$pdo:ident, $size:literal; $count:literal]:
        $($field:ident: $type:ident at $first:literal, $length:literal;)*
    ) => {
        pub struct $pdo {
            $($field: $type,)*
        }

        values!($image = [$pdo; $count]: $($field)*);

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = pack;
            const UNPACK: Unpack<Self, $bytes> = unpack;
        }
    };
}

images!(in_place);

/// Places of the program's own, and a frame of `N` bytes.
trait Places<const N: usize> {
    fn write(&self, frame: &mut [u8; N]);
    fn read(&mut self, frame: &[u8; N]);
}

extern "C-unwind" fn pack<P: Places<N>, const N: usize>(places: &P, frame: &mut [u8; N]) {
    places.write(frame);
}

extern "C-unwind" fn unpack<P: Places<N>, const N: usize>(frame: &[u8; N], places: &mut P) {
    places.read(frame);
}

impl Places<42> for C887Outputs {
    #[inline]
    fn write(&self, frame: &mut [u8; 42]) {
        for (mut view, pdo) in c887::Outputs::view(frame).axes_mut().into_iter().zip(self) {
            view.set_controlword(c887::Controlword(pdo.controlword));
            view.set_modes_of_operation(pdo.mode);
            view.set_target_position(pdo.position);
        }
    }

    #[inline]
    fn read(&mut self, frame: &[u8; 42]) {
        for (view, pdo) in c887::Outputs::view(frame).axes().into_iter().zip(self) {
            pdo.controlword = view.controlword().0;
            pdo.mode = view.modes_of_operation();
            pdo.position = view.target_position();
        }
    }
}

impl Places<66> for C887Inputs {
    #[inline]
    fn write(&self, frame: &mut [u8; 66]) {
        for (mut view, pdo) in c887::Inputs::view(frame).axes_mut().into_iter().zip(self) {
            view.set_statusword(c887::Statusword(pdo.statusword));
            view.set_modes_of_operation_display(pdo.mode);
            view.set_position_actual_value(pdo.position);
            view.set_following_error_actual_value(pdo.following_error);
        }
    }

    #[inline]
    fn read(&mut self, frame: &[u8; 66]) {
        for (view, pdo) in c887::Inputs::view(frame).axes().into_iter().zip(self) {
            pdo.statusword = view.statusword().0;
            pdo.mode = view.modes_of_operation_display();
            pdo.position = view.position_actual_value();
            pdo.following_error = view.following_error_actual_value();
        }
    }
}

impl Places<40> for S700Inputs {
    #[inline]
    fn write(&self, frame: &mut [u8; 40]) {
        let ([pdo], mut view) = (self, s700::s700::TxPdo1B0B::view(frame));
        view.set_position_actual_value_1(pdo.position_1);
        view.set_position_actual_value_2(pdo.position_2);
        view.set_velocity_actual_value(pdo.velocity);
        view.set_current_actual_value(pdo.current);
        view.set_statusword(s700::s700::Statusword(pdo.statusword));
        view.set_drive_errors(pdo.errors);
        view.set_drive_warnings(pdo.warnings);
        view.set_digital_io(s700::s700::DigitalIo(pdo.digital_io as u16));
        view.set_analog_inputs_analog_input_1(pdo.analog_1);
        view.set_analog_inputs_analog_input_2(pdo.analog_2);
        view.set_internal_following_error(pdo.following_error);
        view.set_motion_task_status(pdo.motion_task);
    }

    #[inline]
    fn read(&mut self, frame: &[u8; 40]) {
        let ([pdo], view) = (self, s700::s700::TxPdo1B0B::view(frame));
        pdo.position_1 = view.position_actual_value_1();
        pdo.position_2 = view.position_actual_value_2();
        pdo.velocity = view.velocity_actual_value();
        pdo.current = view.current_actual_value();
        pdo.statusword = view.statusword().0;
        pdo.errors = view.drive_errors();
        pdo.warnings = view.drive_warnings();
        pdo.digital_io = view.digital_io().0.into();
        pdo.analog_1 = view.analog_inputs_analog_input_1();
        pdo.analog_2 = view.analog_inputs_analog_input_2();
        pdo.following_error = view.internal_following_error();
        pdo.motion_task = view.motion_task_status();
    }
}

impl Places<58> for PilzInputs {
    #[inline]
    fn write(&self, frame: &mut [u8; 58]) {
        for (mut view, pdo) in pmc_sc6::double::Inputs::view(frame).axes_mut().into_iter().zip(self) {
            view.set_statusword(pmc_sc6::double::Statusword(pdo.statusword));
            view.set_modes_of_operation_display(pdo.mode);
            view.set_position_actual_value(pdo.position);
            view.set_velocity_actual_value(pdo.velocity);
            view.set_torque_actual_value(pdo.torque);
            view.set_following_error_actual_value(pdo.following_error);
            view.set_digital_inputs(pmc_sc6::double::DigitalInputs(pdo.digital_inputs));
            view.set_additional_position_actual_value_1st_additional_position_actual_value(
                pdo.additional_position,
            );
            view.set_status_word_2(pdo.statusword_2);
            view.set_status_word_user_defined(pdo.statusword_user);
        }
    }

    #[inline]
    fn read(&mut self, frame: &[u8; 58]) {
        for (view, pdo) in pmc_sc6::double::Inputs::view(frame).axes().into_iter().zip(self) {
            pdo.statusword = view.statusword().0;
            pdo.mode = view.modes_of_operation_display();
            pdo.position = view.position_actual_value();
            pdo.velocity = view.velocity_actual_value();
            pdo.torque = view.torque_actual_value();
            pdo.following_error = view.following_error_actual_value();
            pdo.digital_inputs = view.digital_inputs().0;
            pdo.additional_position =
                view.additional_position_actual_value_1st_additional_position_actual_value();
            pdo.statusword_2 = view.status_word_2();
            pdo.statusword_user = view.status_word_user_defined();
        }
    }
}
