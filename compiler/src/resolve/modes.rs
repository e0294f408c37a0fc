//! Modes of operation.

use super::context::Context;
use super::{facts, keys, words};
use crate::model::{Address, HomingBits, Mode, ModeBits, ModeChange, MotionCommand, Provenance, StopOption};
use crate::raw::{Entity, RawHomingBits, RawMode, RawModeChange, RawMotionCommand, RawStopOption};
use crate::source::Origin;

/// The modes, by code.
pub(super) fn modes(context: &mut Context<'_>, raw: Vec<Entity<RawMode>>) -> Vec<Mode> {
    let mut modes: Vec<Mode> = raw.into_iter().filter_map(|entity| mode(context, entity)).collect();
    modes.sort_by_key(|mode| mode.code);
    modes
}

fn mode(context: &mut Context<'_>, entity: Entity<RawMode>) -> Option<Mode> {
    let Entity { key, origin, raw, facts } = entity;
    let code = keys::number(&key).and_then(|code| i16::try_from(code).ok());
    if code.is_none() {
        context.invalid(&key, "the code of a mode of operation", origin.header());
    }
    Some(Mode {
        code: code?,
        aliases: raw.aliases,
        id: raw.id,
        name: raw.name,
        about: raw.about,
        cyclic: raw.cyclic,
        supported_bit: raw.supported_bit,
        objects: objects(context, &raw.objects, &origin),
        control_bits: ModeBits { fields: words::fields(context, &raw.control_bits, &origin, "control-bits") },
        status_bits: ModeBits { fields: words::fields(context, &raw.status_bits, &origin, "status-bits") },
        homing_bits: raw.homing_bits.and_then(|bits| homing_bits(context, &bits, &origin)),
        conditions: raw.conditions,
        cautions: raw.cautions,
        commands: raw.commands.into_iter().map(motion_command).collect(),
        source: facts::source(context, &facts),
        origin,
    })
}

/// The entries a mode uses; a profile names all that it could use, of which a device has some.
fn objects(context: &mut Context<'_>, raw: &[String], origin: &Origin) -> Vec<Address> {
    if context.provenance(origin, "objects") == Provenance::Profile {
        return raw.iter().filter_map(|text| context.names.find(text).ok()).collect();
    }
    context.addresses(raw, origin, "objects")
}

/// The bits of a reference run; both words have 16.
fn homing_bits(context: &mut Context<'_>, raw: &RawHomingBits, origin: &Origin) -> Option<HomingBits> {
    let RawHomingBits { start, reached, attained, error } = *raw;
    let bits = [("start", start), ("reached", reached), ("attained", attained), ("error", error)];
    let beyond = bits.into_iter().filter(|(_, bit)| *bit > 15).inspect(|(key, bit)| {
        let at = origin.value(&format!("homing-bits.{key}"));
        context.invalid(&bit.to_string(), "a bit of a word, 0 to 15", at);
    });
    (beyond.count() == 0).then_some(HomingBits { start, reached, attained, error })
}

fn motion_command(raw: RawMotionCommand) -> MotionCommand {
    let RawMotionCommand { code, name, when, about, control, variables } = raw;
    MotionCommand { code, name, when, about, control, variables }
}

/// The changes of mode, in the order in which they were written.
pub(super) fn changes(context: &Context<'_>, raw: Vec<Entity<RawModeChange>>) -> Vec<ModeChange> {
    raw.into_iter()
        .map(|Entity { raw, facts, origin, .. }| ModeChange {
            from: raw.from,
            to: raw.to,
            done_when: raw.done_when,
            fault_when: raw.fault_when,
            about: raw.about,
            source: facts::source(context, &facts),
            origin,
        })
        .collect()
}

/// What stops the drive, in the order in which it was written.
pub(super) fn stop_options(context: &Context<'_>, raw: Vec<Entity<RawStopOption>>) -> Vec<StopOption> {
    raw.into_iter()
        .map(|Entity { raw, facts, .. }| StopOption {
            action: raw.action,
            transitions: raw.transitions,
            reaction: raw.reaction,
            ramp: raw.ramp,
            about: raw.about,
            source: facts::source(context, &facts),
        })
        .collect()
}
