//! What the device does with what it is asked for at the wrong time.

use super::context::Context;
use super::{facts, states};
use crate::model::{DeviceControl, Refusal};
use crate::raw::{Entity, RawDeviceControl, RawRefusal};

/// What the device does with what is not allowed; what is not said is ignored, as CiA 402 has it.
pub(super) fn device_control(
    context: &mut Context<'_>,
    entity: Entity<RawDeviceControl>,
    states: &[String],
) -> DeviceControl {
    let Entity { raw, facts, origin, .. } = entity;
    DeviceControl {
        wrong_command: raw.wrong_command.map_or(Refusal::Ignored, refusal),
        wrong_mode: raw.wrong_mode.map_or(Refusal::Ignored, refusal),
        modes_selectable_in: states::bind_all(
            context,
            &raw.modes_selectable_in,
            states,
            &origin,
            "modes-selectable-in",
        ),
        about: raw.about,
        source: facts::source(context, &facts),
    }
}

fn refusal(raw: RawRefusal) -> Refusal {
    match raw {
        RawRefusal::Ignored => Refusal::Ignored,
        RawRefusal::Fault => Refusal::Fault,
    }
}
