//! Generated: structs by value.

use devc_runtime::pdo::ProcessData;

use super::{Image, Pack, Unpack, Values};
use crate::{c887, pmc_sc6, s700};

pub use crate::c887::{Inputs as C887Inputs, Outputs as C887Outputs};
pub use crate::pmc_sc6::double::Inputs as PilzInputs;
pub use crate::s700::s700::TxPdo1B0B as S700Inputs;

extern "C-unwind" fn pack<P: ProcessData<Image = [u8; N]>, const N: usize>(value: &P, frame: &mut [u8; N]) {
    *frame = (*value).pack();
}

extern "C-unwind" fn unpack<P: ProcessData<Image = [u8; N]>, const N: usize>(frame: &[u8; N], value: &mut P) {
    *value = P::unpack(*frame);
}

macro_rules! by_value {
    ($image:ident, $bytes:literal: $value:ident => $fields:expr) => {
        impl Values for $image {
            const ZERO: Self = $image::unpack([0; $bytes]);

            fn fields(&self) -> Vec<i64> {
                let $value = self;
                $fields
            }
        }

        impl Image<$bytes> for $image {
            const PACK: Pack<Self, $bytes> = pack;
            const UNPACK: Unpack<Self, $bytes> = unpack;
        }
    };
}

by_value!(C887Outputs, 42: outputs => outputs.axes.iter().flat_map(c887_out).collect());
by_value!(C887Inputs, 66: inputs => inputs.axes.iter().flat_map(c887_in).collect());
by_value!(S700Inputs, 40: inputs => s700_in(inputs).to_vec());
by_value!(PilzInputs, 58: inputs => inputs.axes.iter().flat_map(pilz_in).collect());

fn c887_out(pdo: &c887::RxPdo1600) -> [i64; 3] {
    [pdo.controlword.0.into(), pdo.modes_of_operation.into(), pdo.target_position.into()]
}

fn c887_in(pdo: &c887::TxPdo1A00) -> [i64; 4] {
    [
        pdo.statusword.0.into(),
        pdo.modes_of_operation_display.into(),
        pdo.position_actual_value.into(),
        pdo.following_error_actual_value.into(),
    ]
}

fn s700_in(pdo: &s700::s700::TxPdo1B0B) -> [i64; 12] {
    [
        pdo.position_actual_value_1.into(),
        pdo.position_actual_value_2.into(),
        pdo.velocity_actual_value.into(),
        pdo.current_actual_value.into(),
        pdo.statusword.0.into(),
        pdo.drive_errors.into(),
        pdo.drive_warnings.into(),
        pdo.digital_io.0.into(),
        pdo.analog_inputs_analog_input_1.into(),
        pdo.analog_inputs_analog_input_2.into(),
        pdo.internal_following_error.into(),
        pdo.motion_task_status.into(),
    ]
}

fn pilz_in(pdo: &pmc_sc6::double::TxPdo1A00) -> [i64; 10] {
    [
        pdo.statusword.0.into(),
        pdo.modes_of_operation_display.into(),
        pdo.position_actual_value.into(),
        pdo.velocity_actual_value.into(),
        pdo.torque_actual_value.into(),
        pdo.following_error_actual_value.into(),
        pdo.digital_inputs.0.into(),
        pdo.additional_position_actual_value_1st_additional_position_actual_value.into(),
        pdo.status_word_2.into(),
        pdo.status_word_user_defined.into(),
    ]
}
