//! How the device keeps time with the master.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::number::duration;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{CycleTime, DeadTime, ModePdo, SyncMode, SyncSignal};

/// The cycles that the dead time is worked out for.
const EXAMPLES_NS: [u64; 2] = [1_000_000, 2_000_000];

/// How the device keeps time with the master.
pub(super) fn page(
    context: &Context<'_>,
    sync_modes: &[SyncMode],
    times: &[CycleTime],
    dead_time: Option<&DeadTime>,
) -> Page {
    let mut page = Page::default();
    page.table(modes(context, sync_modes));
    page.table(cycle_times(context, times));
    dead_time.iter().for_each(|dead_time| self::dead_time(context, dead_time, &mut page));
    page
}

fn modes(context: &Context<'_>, sync_modes: &[SyncMode]) -> Table {
    let titles = ["Mode", "AssignActivate", "SYNC0", "SYNC1", "Notes", "Source"];
    Table::of(titles, sync_modes, |mode| {
        [
            name(mode),
            code(format!("0x{:04X}", mode.assign_activate)),
            mode.sync0.as_ref().map_or(String::new(), signal),
            mode.sync1.as_ref().map_or(String::new(), signal),
            notes(context, mode),
            context.said(mode.source.as_ref(), &mode.origin),
        ]
    })
}

/// What it makes of the sync managers, and what else is said.
fn notes(context: &Context<'_>, mode: &SyncMode) -> String {
    let managers = mode.managers.iter().map(|manager| {
        let pdo = |it: &ModePdo| {
            let times = it.oversampling.map(|times| format!(", {times} times"));
            format!("{}{}", context.index(it.pdo), times.unwrap_or_default())
        };
        let pdos = manager.pdos.iter().map(pdo).collect::<Vec<_>>().join("; ");
        let kind = manager.sync_type.map(|kind| format!("type of synchronisation {kind}"));
        let said = [Some(pdos).filter(|pdos| !pdos.is_empty()), kind].into_iter().flatten();
        format!("{}: {}", text(&manager.id), said.collect::<Vec<_>>().join("; "))
    });
    let about = mode.about.iter().map(|about| context.prose(about));
    about.chain(managers).collect::<Vec<_>>().join("<br>")
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
    let titles = ["Cycle time", "At least", "To choose from", "Modes", "Notes", "Source"];
    Table::of(titles, times, |time| {
        [
            text(&time.name),
            time.min.map_or(String::new(), |least| duration(least.0)),
            list(time.choices.iter().map(|choice| duration(choice.0))),
            list(time.modes.iter().map(i16::to_string)),
            context.optional(time.about.as_deref()),
            context.said(time.source.as_ref(), &time.origin),
        ]
    })
}

fn dead_time(context: &Context<'_>, dead_time: &DeadTime, page: &mut Page) {
    page.heading(3, "Dead time");
    page.text(context.paragraphs(dead_time.about.as_deref()));
    page.text(format!("> dead time = {} × cycle time + {}", dead_time.cycles, duration(dead_time.plus.0)));
    page.table(Table::of(["Cycle time", "Dead time"], EXAMPLES_NS, |cycle| {
        let total = u64::from(dead_time.cycles) * cycle + dead_time.plus.0;
        [duration(cycle), format!("**{}**", duration(total))]
    }));
    page.text(context.said_line(dead_time.source.as_ref(), &dead_time.origin));
}
