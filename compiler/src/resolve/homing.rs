//! Homing methods.

use super::context::Context;
use super::ids::Siblings;
use super::{facts, keys};
use crate::model::{Alternative, HomingMethod, Way};
use crate::raw::{Entity, RawDirection, RawHomingMethod};

/// The homing methods, by number.
pub(super) fn methods(context: &mut Context<'_>, raw: Vec<Entity<RawHomingMethod>>) -> Vec<HomingMethod> {
    let mut methods = Vec::new();
    let mut ids = Siblings::default();
    for Entity { key, origin, raw, facts } in raw {
        let Some(number) = keys::number(&key).and_then(|number| i8::try_from(number).ok()) else {
            context.invalid(&key, "the number of a homing method, -128 to 127", origin.header());
            continue;
        };
        methods.push(HomingMethod {
            number,
            aliases: raw.aliases,
            id: ids.claim(&raw.name),
            name: raw.name,
            method: raw.method,
            direction: raw.direction.map(|direction| match direction {
                RawDirection::Positive => Way::Positive,
                RawDirection::Negative => Way::Negative,
            }),
            pulse: raw.pulse,
            target: raw.target,
            parameters: raw.parameters,
            steps: raw.steps,
            alternatives: raw
                .alternatives
                .into_iter()
                .map(|case| Alternative { when: case.when, steps: case.steps })
                .collect(),
            about: raw.about,
            source: facts::source(context, &facts),
            origin,
        });
    }
    methods.sort_by_key(|method| method.number);
    methods
}
