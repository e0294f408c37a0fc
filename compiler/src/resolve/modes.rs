//! Modes of operation.

use super::context::Context;
use crate::model::{Address, HomingBits, Mode};
use crate::raw::RawMode;
use crate::source::{Layer, Origin};

/// The modes, by code.
pub(super) fn modes(context: &mut Context<'_>, raw: Vec<RawMode>) -> Vec<Mode> {
    let mut modes: Vec<Mode> = raw.into_iter().map(|raw| mode(context, raw)).collect();
    modes.sort_by_key(|mode| mode.code);
    modes
}

fn mode(context: &mut Context<'_>, raw: RawMode) -> Mode {
    let RawMode {
        code,
        key: _,
        id,
        name,
        about,
        aliases,
        cyclic,
        supported_bit,
        objects,
        control_bits,
        status_bits,
        homing_bits,
        conditions,
        cautions,
        commands,
        source,
        origin,
    } = raw;
    let objects = self::objects(context, &objects, &origin);
    let homing_bits = homing_bits.filter(|bits| within(context, *bits, &origin));
    Mode {
        code,
        aliases,
        id,
        name,
        about,
        cyclic,
        supported_bit,
        objects,
        control_bits,
        status_bits,
        homing_bits,
        conditions,
        cautions,
        commands,
        source,
        origin,
    }
}

/// The entries a mode uses; a profile names all that it could use, of which a device has some.
fn objects(context: &mut Context<'_>, raw: &[String], origin: &Origin) -> Vec<Address> {
    if origin.layer("objects") == Some(Layer::Profile) {
        return raw.iter().filter_map(|text| context.names.find(text).ok()).collect();
    }
    context.addresses(raw, origin, "objects")
}

/// Whether the bits of a reference run are bits of words of 16.
fn within(context: &mut Context<'_>, bits: HomingBits, origin: &Origin) -> bool {
    let HomingBits { start, reached, attained, error } = bits;
    let bits = [("start", start), ("reached", reached), ("attained", attained), ("error", error)];
    let beyond = bits.into_iter().filter(|(_, bit)| *bit > 15).inspect(|(key, bit)| {
        let at = origin.value(&format!("homing-bits.{key}"));
        context.invalid(&bit.to_string(), "a bit of a word, 0 to 15", at);
    });
    beyond.count() == 0
}
