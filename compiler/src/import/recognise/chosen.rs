//! Start-up commands that are a choice with a key of its own: the mode of operation and the cycle time.

use devc_start_up::Period;

use super::super::read::InitCmd;
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set_some};
use super::axes::Axes;
use super::clocks::time;
use super::derived::Basis;
use super::references::References;
use super::words::alike;

/// The objects that are written, on the first axis.
const MODE: u16 = 0x6060;
const CYCLE: u16 = 0x60C2;

/// What a start-up list is seen with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surroundings<'s> {
    pub(super) references: &'s References,
    pub(super) axes: &'s Axes,
    pub(super) basis: &'s Basis<'s>,
}

/// What is chosen by writing it, with the commands that do.
#[derive(Debug, Default)]
pub(super) struct Chosen<'c> {
    mode: Option<i8>,
    /// In nanoseconds.
    cycle: Option<u64>,
    commands: Vec<&'c InitCmd>,
}

impl<'c> Chosen<'c> {
    /// A choice holds for all axes, and comes before whatever else is written on the way to Safe-Operational. Commands
    /// that say it otherwise are writes as any others.
    pub(super) fn of(commands: &[&'c InitCmd], surroundings: &Surroundings<'_>) -> Self {
        let on_axes = |leading: u16| -> Vec<u16> {
            let has = |index: &u16| surroundings.references.get(*index, 0).is_some();
            surroundings.axes.indices(leading).into_iter().filter(has).collect()
        };
        let mode = same(commands, &on_axes(MODE), 0).map(|(byte, written)| (byte.cast_signed(), written));
        let cycle = cycle(commands, &on_axes(CYCLE));
        let (mode_of, cycle_of) = (mode.as_ref().map(|it| it.0), cycle.as_ref().map(|it| it.0));
        let written = [mode.map(|it| it.1), cycle.map(|it| it.1)].into_iter().flatten().flatten().collect();
        let chosen = Self { mode: mode_of, cycle: cycle_of, commands: written };
        let others = commands.iter().skip_while(|it| chosen.has(it) || !is_on_the_way(it));
        if others.clone().any(|it| chosen.has(it)) { Self::default() } else { chosen }
    }

    /// Whether a command is part of it.
    pub(super) fn has(&self, command: &InitCmd) -> bool {
        self.commands.iter().any(|known| std::ptr::eq(*known, command))
    }

    pub(super) fn keys(&self) -> Keys {
        let mut keys = Keys::new();
        set_some(&mut keys, "mode", self.mode.map(|mode| Toml::Integer(mode.into())));
        let cycle = self.cycle.and_then(|ns| i64::try_from(ns).ok());
        set_some(&mut keys, "cycle-time", cycle.map(|ns| Toml::text(time(ns))));
        keys
    }

    /// Reports what a command says it is for, if that is more than its key says.
    pub(super) fn comment(&self, command: &InitCmd, references: &References, report: &mut Report) {
        let target = references.get(command.index, command.subindex);
        let name = target.and_then(|target| target.name.as_deref()).unwrap_or_default();
        if let Some(comment) = command.comment.as_ref().filter(|comment| !alike(comment, name)) {
            let key = if command.subindex == 0 { "mode" } else { "cycle-time" };
            lose_comment(command, comment, &format!("`{key}` says what is written"), report);
        }
    }
}

/// Reports a command that a description cannot say.
pub(super) fn lose(command: &InitCmd, why: &str, report: &mut Report) {
    let place = format!("0x{:04X}:{:02X}", command.index, command.subindex);
    let data: String = command.data.iter().map(|byte| format!("{byte:02X}")).collect();
    let what = format!("InitCmd {place} in {}", command.transitions.join(", "));
    report.lose(command.at, command.facts, what, format!("{why}; it writes {data}"));
}

/// Reports the comment of a command that a key stands for.
pub(super) fn lose_comment(command: &InitCmd, comment: &str, why: &str, report: &mut Report) {
    report.lose(command.at, 1, "InitCmd/Comment", format!("`{comment}`: {why}"));
}

/// Whether it is written between Pre-Operational and Safe-Operational.
fn is_on_the_way(command: &InitCmd) -> bool {
    command.transitions.iter().any(|it| it == "PS")
}

/// The one byte that is written to an entry of objects, the same to all; with the commands that do.
fn same<'c>(commands: &[&'c InitCmd], objects: &[u16], subindex: u8) -> Option<(u8, Vec<&'c InitCmd>)> {
    let written = objects.iter().map(|index| {
        let mut found = commands.iter().filter(|it| it.index == *index && it.subindex == subindex);
        found.next().filter(|_| found.next().is_none()).copied()
    });
    let written = written.collect::<Option<Vec<_>>>()?;
    let is_plain =
        |it: &&InitCmd| matches!(it.transitions.as_slice(), [only] if only == "PS") && !it.complete_access;
    let [byte] = *written.first()?.data.as_slice() else { return None };
    written.iter().all(|it| is_plain(it) && it.data == [byte]).then_some((byte, written))
}

/// The cycle time in nanoseconds, if it is written as a master would that is told it.
fn cycle<'c>(commands: &[&'c InitCmd], objects: &[u16]) -> Option<(u64, Vec<&'c InitCmd>)> {
    let (count, counts) = same(commands, objects, 1)?;
    let (exponent, exponents) = same(commands, objects, 2)?;
    let period = Period { count, exponent: exponent.cast_signed() };
    let power = u32::try_from(i32::from(period.exponent) + 9).ok()?;
    let ns = 10_u64.checked_pow(power)?.checked_mul(count.into())?;
    (Period::of_ns(ns) == Some(period)).then(|| (ns, [counts, exponents].concat()))
}
