//! Time.

use super::context::Context;
use super::facts;
use crate::model::{CycleTime, DeadTime, SyncMode, SyncSignal};
use crate::raw::{Duration, Entity, RawCycleTime, RawDeadTime, RawSyncMode, RawSyncSignal};

/// The ways to keep time, the default first.
pub(super) fn sync_modes(context: &Context<'_>, raw: Vec<Entity<RawSyncMode>>) -> Vec<SyncMode> {
    let mut modes: Vec<_> = raw
        .into_iter()
        .map(|Entity { key, raw, facts, origin }| SyncMode {
            id: key,
            name: raw.name,
            assign_activate: raw.assign_activate,
            default: raw.default,
            sync0: raw.sync0.map(|signal| self::signal(&signal)),
            sync1: raw.sync1.map(|signal| self::signal(&signal)),
            about: raw.about,
            source: facts::source(context, &facts),
            origin,
        })
        .collect();
    modes.sort_by_key(|mode| !mode.default);
    modes
}

fn signal(raw: &RawSyncSignal) -> SyncSignal {
    SyncSignal { cycles: raw.cycles.unwrap_or(1), shift_ns: raw.shift.unwrap_or_default().0 }
}

/// How often set values may come, in the order in which it was written.
pub(super) fn cycle_times(context: &Context<'_>, raw: Vec<Entity<RawCycleTime>>) -> Vec<CycleTime> {
    raw.into_iter()
        .map(|Entity { key, raw, facts, .. }| CycleTime {
            id: key,
            name: raw.name,
            min_ns: raw.min.map(|Duration(ns)| ns),
            choices_ns: raw.choices.into_iter().map(|Duration(ns)| ns).collect(),
            about: raw.about,
            source: facts::source(context, &facts),
        })
        .collect()
}

/// The time from a set value to its effect.
pub(super) fn dead_time(context: &Context<'_>, entity: Entity<RawDeadTime>) -> DeadTime {
    let Entity { raw, facts, .. } = entity;
    DeadTime {
        cycles: raw.cycles,
        plus_ns: raw.plus.0,
        about: raw.about,
        source: facts::source(context, &facts),
    }
}
