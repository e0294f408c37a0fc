//! What the tables of objects name: enumerations, units, modes and other objects.
//!
//! It is asked of each table as it was read, be there an entry that takes over what it says or not.

use super::context::Context;
use super::kept;
use crate::model::Section;
use crate::raw::{RawDevice, RawEntry, RawObject, RawTrigger, RawValues};
use crate::source::Origin;

/// What there is to be named.
struct Known {
    enumerations: Vec<String>,
    units: Vec<String>,
    modes: Vec<i16>,
}

/// Reports what objects name and nobody describes.
pub(super) fn judge(context: &mut Context<'_>, raw: &RawDevice) {
    let modes = raw.modes.iter().flat_map(|mode| mode.aliases.iter().copied().chain([mode.code]));
    let known = Known {
        enumerations: context.enumerations.iter().map(|known| known.id.clone()).collect(),
        units: raw.units.iter().map(|unit| unit.key.clone()).collect(),
        modes: modes.collect(),
    };
    raw.objects.iter().for_each(|raw| object(context, raw, &known));
}

fn object(context: &mut Context<'_>, raw: &RawObject, known: &Known) {
    value(context, &raw.value, &raw.origin, known);
    raw.entries.iter().for_each(|raw| value(context, &raw.value, &raw.origin, known));
    raw.per_axis.iter().for_each(|(_, raw)| object(context, raw, known));
}

fn value(context: &mut Context<'_>, raw: &RawEntry, origin: &Origin, known: &Known) {
    if let Some(RawValues::Shared(name)) = &raw.values {
        let (section, at) = (Section::Enumerations, origin.value("values"));
        context.bind_to(section, name, &known.enumerations, "enumeration", at);
    }
    if let Some(unit) = &raw.unit {
        context.bind_to(Section::Units, unit, &known.units, "unit", origin.value("unit"));
    }
    if let Some(RawTrigger { mode, uses, updates, .. }) = &raw.trigger {
        mode.iter().for_each(|code| kept::mode(context, *code, &known.modes, origin.value("trigger.mode")));
        for (key, named) in [("uses", uses), ("updates", updates)] {
            context.addresses(named, origin, &format!("trigger.{key}"));
        }
    }
}
