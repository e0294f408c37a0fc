//! What a person sees and does.

use super::context::Context;
use super::facts;
use super::parameters::untyped;
use crate::model::{Connector, Led, LedPattern, Limit, MasterSetting, Procedure, Step};
use crate::raw::{
    Entity, RawConnector, RawLed, RawLedPattern, RawLimit, RawMasterSetting, RawProcedure, RawStep,
};
use crate::source::Origin;

/// Lights.
pub(super) fn leds(context: &Context<'_>, raw: Vec<Entity<RawLed>>) -> Vec<Led> {
    raw.into_iter()
        .map(|Entity { key, raw, facts, .. }| Led {
            id: key,
            name: raw.name,
            colour: raw.colour,
            about: raw.about,
            patterns: raw.patterns.into_iter().map(pattern).collect(),
            source: facts::source(context, &facts),
        })
        .collect()
}

fn pattern(raw: RawLedPattern) -> LedPattern {
    LedPattern { shows: raw.shows, means: raw.means }
}

/// Sockets.
pub(super) fn connectors(context: &Context<'_>, raw: Vec<Entity<RawConnector>>) -> Vec<Connector> {
    raw.into_iter()
        .map(|Entity { key, raw, facts, .. }| Connector {
            id: key,
            name: raw.name,
            kind: raw.kind,
            about: raw.about,
            source: facts::source(context, &facts),
        })
        .collect()
}

/// What is to be set in the master.
pub(super) fn master_settings(
    context: &Context<'_>,
    raw: Vec<Entity<RawMasterSetting>>,
) -> Vec<MasterSetting> {
    raw.into_iter()
        .map(|Entity { raw, facts, .. }| MasterSetting {
            name: raw.name,
            value: raw.value,
            per_axis: raw.per_axis,
            about: raw.about,
            source: facts::source(context, &facts),
        })
        .collect()
}

/// Things to do in order.
pub(super) fn procedures(context: &mut Context<'_>, raw: Vec<Entity<RawProcedure>>) -> Vec<Procedure> {
    raw.into_iter()
        .map(|Entity { key, raw, facts, origin }| Procedure {
            id: key,
            name: raw.name,
            about: raw.about,
            steps: steps(context, &raw.steps, &origin),
            source: facts::source(context, &facts),
        })
        .collect()
}

fn steps(context: &mut Context<'_>, raw: &[RawStep], origin: &Origin) -> Vec<Step> {
    raw.iter()
        .enumerate()
        .map(|(i, step)| Step {
            text: step.r#do.clone(),
            address: step
                .object
                .as_deref()
                .and_then(|object| context.address(object, origin.value(&format!("steps.{i}.object")))),
            write: step.write.as_ref().map(untyped),
        })
        .collect()
}

/// Figures that the device keeps to or asks for, in the order in which they were written.
pub(super) fn limits(context: &Context<'_>, raw: Vec<Entity<RawLimit>>) -> Vec<Limit> {
    raw.into_iter()
        .map(|Entity { key, raw, facts, .. }| Limit {
            id: key,
            name: raw.name,
            value: raw.value,
            about: raw.about,
            source: facts::source(context, &facts),
        })
        .collect()
}
