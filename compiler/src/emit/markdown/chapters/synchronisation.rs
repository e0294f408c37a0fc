//! How the device keeps time with the master.

use serde::Serialize;

use crate::emit::markdown::chapter::Chapter;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::number::duration;
use crate::emit::markdown::table::Table;
use crate::model::{CycleTime, DeadTime, SyncMode, SyncSignal};

/// The cycles that the dead time is worked out for.
const EXAMPLES_NS: [u64; 2] = [1_000_000, 2_000_000];

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    modes: Table,
    cycle_times: Table,
    dead_time: Option<DeadTimeView>,
}

#[derive(Serialize)]
struct DeadTimeView {
    formula: String,
    about: String,
    examples: Table,
    source: String,
}

impl Chapter for View {
    type Parts<'d> = (&'d [SyncMode], &'d [CycleTime], Option<&'d DeadTime>);

    const ID: &'static str = "synchronisation";
    const TITLE: &'static str = "Synchronisation";
    const TEMPLATE: &'static str = include_str!("../templates/synchronisation.md.j2");

    fn view(context: &Context<'_>, (sync_modes, times, dead_time): Self::Parts<'_>) -> Option<Self> {
        let dead_time = dead_time.map(|dead_time| dead_time_view(context, dead_time));
        let view =
            Self { modes: modes(context, sync_modes), cycle_times: cycle_times(context, times), dead_time };
        let shown = !view.modes.is_empty() || !view.cycle_times.is_empty() || view.dead_time.is_some();
        shown.then_some(view)
    }
}

fn modes(context: &Context<'_>, sync_modes: &[SyncMode]) -> Table {
    let titles = ["Mode", "AssignActivate", "SYNC0", "SYNC1", "Notes", "Source"];
    Table::of(titles, sync_modes, |mode| {
        [
            name(mode),
            code(format!("0x{:04X}", mode.assign_activate)),
            mode.sync0.as_ref().map_or(String::new(), signal),
            mode.sync1.as_ref().map_or(String::new(), signal),
            context.optional(mode.about.as_deref()),
            context.said(mode.source.as_ref(), &mode.origin),
        ]
    })
}

fn name(mode: &SyncMode) -> String {
    let default = if mode.default { " (default)" } else { "" };
    format!("**{}**{default}", text(&mode.name))
}

fn signal(signal: &SyncSignal) -> String {
    let SyncSignal { cycles, period, shift, shift_cycles, of_inputs } = signal;
    let period = match (period, *cycles) {
        (Some(period), _) => format!("every {}", duration(period.0)),
        (None, 0 | 1) => "every cycle".into(),
        (None, cycles) if cycles < 0 => format!("{} times a cycle", cycles.unsigned_abs()),
        (None, cycles) => format!("every {cycles} cycles"),
    };
    let way = if shift.0 < 0 { "earlier" } else { "later" };
    let shift = (shift.0 != 0).then(|| format!("{} {way}", duration(shift.0.unsigned_abs())));
    let cycles = shift_cycles.map(|cycles| format!("{cycles} cycles later"));
    let counted = of_inputs.then(|| "counted from the inputs".into());
    list([period].into_iter().chain(shift).chain(cycles).chain(counted))
}

fn cycle_times(context: &Context<'_>, times: &[CycleTime]) -> Table {
    let titles = ["Cycle time", "At least", "To choose from", "Notes", "Source"];
    Table::of(titles, times, |time| {
        [
            text(&time.name),
            time.min.map_or(String::new(), |least| duration(least.0)),
            list(time.choices.iter().map(|choice| duration(choice.0))),
            context.optional(time.about.as_deref()),
            context.said(time.source.as_ref(), &time.origin),
        ]
    })
}

fn dead_time_view(context: &Context<'_>, dead_time: &DeadTime) -> DeadTimeView {
    DeadTimeView {
        formula: format!("dead time = {} × cycle time + {}", dead_time.cycles, duration(dead_time.plus.0)),
        about: context.paragraphs(dead_time.about.as_deref()),
        examples: Table::of(["Cycle time", "Dead time"], EXAMPLES_NS, |cycle| {
            let total = u64::from(dead_time.cycles) * cycle + dead_time.plus.0;
            [duration(cycle), format!("**{}**", duration(total))]
        }),
        source: context.said_line(dead_time.source.as_ref(), &dead_time.origin),
    }
}
