//! Values that are of the right type, but none of those that a standard or the format has.
//!
//! The types that descriptions are read into are wider than what may stand in them; here is what they could hold and
//! should not.

use super::context::Context;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Duration, are_ports};
use crate::raw::{RawAxes, RawDevice, RawHead, RawObject};
use crate::source::{Location, keys};

/// Reports every value of a device that its key cannot have.
pub(super) fn judge(context: &mut Context<'_>, raw: &RawDevice) {
    raw.head.iter().for_each(|head| physics(context, head));
    raw.axes.iter().for_each(|raw| axes(context, raw));
    raw.objects.iter().for_each(|object| id(context, object));
    communication_states(context, raw);
    al_status_codes(context, raw);
    cycles(context, raw);
    registers(context, raw);
}

/// The letters of the ports.
fn physics(context: &mut Context<'_>, head: &RawHead) {
    let Some(text) = &head.physics else { return };
    if are_ports(text) {
        return;
    }
    let at = head.origin.value("physics");
    let message = format!("`{text}` means nothing here");
    let label = "expected a letter for each of up to 4 ports: `Y`, `K`, `H`, or a space for none";
    let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at, label);
    let upper = Some(text.to_ascii_uppercase()).filter(|upper| upper != text && are_ports(upper));
    context.diagnostics.push(match upper {
        Some(upper) => fault.fix("write capital letters", at, format!("\"{upper}\"")),
        None => fault,
    });
}

/// Names that references can tell apart from ranges and from nothing, and ranges that do not meet.
fn axes(context: &mut Context<'_>, raw: &RawAxes) {
    for (i, name) in raw.names.iter().enumerate() {
        if name.trim().is_empty() || name.contains("..=") {
            let expected = "a name, which no range of names can be mistaken for";
            context.invalid(name, expected, raw.origin.value(&format!("names.{i}")));
        }
    }
    let shifts = raw.shifts.iter().enumerate();
    let mut ranges: Vec<_> =
        shifts.filter_map(|(i, shift)| Some((keys::range::<u16>(&shift.range)?, i))).collect();
    ranges.sort_by_key(|(range, _)| *range.start());
    for pair in ranges.windows(2) {
        let [(first, i), (second, j)] = pair else { continue };
        if second.start() <= first.end() {
            let at = |i: &usize| raw.origin.value(&format!("shifts.{i}.range"));
            let message = format!("two shifts hold for 0x{:04X}", second.start());
            let fault = Diagnostic::new(&faults::COLLIDING_AXES, message, at(j), "this range");
            context.diagnostics.push(fault.label(at(i), "and this one"));
        }
    }
}

/// Words that references can tell apart from indices and from entries of other objects.
fn id(context: &mut Context<'_>, object: &RawObject) {
    let id = object.head.id.as_deref();
    if let Some(id) = id.filter(|id| id.trim().is_empty() || id.contains(':') || id.starts_with("0x")) {
        let expected = "a word without a colon that does not begin as an index does";
        context.invalid(id, expected, object.origin.value("id"));
    }
}

/// The states that ETG.1000.6 has, by their number in AL control.
fn communication_states(context: &mut Context<'_>, raw: &RawDevice) {
    for state in raw.communication_states.iter().filter(|it| !matches!(it.code, 1 | 2 | 3 | 4 | 8)) {
        let expected = "the number of an EtherCAT state: 1, 2, 3, 4 or 8";
        context.invalid(&state.code.to_string(), expected, state.origin.value("code"));
    }
}

/// The states, each by its letter, and the changes from one to another.
fn al_status_codes(context: &mut Context<'_>, raw: &RawDevice) {
    const STATES: [&str; 5] = ["I", "P", "B", "S", "O"];
    let others = |from: &'static str| STATES.into_iter().filter(move |to| *to != from);
    let changes = STATES.into_iter().flat_map(|from| others(from).map(move |to| format!("{from}{to}")));
    let known: Vec<String> = STATES.map(str::to_owned).into_iter().chain(changes).collect();
    for code in &raw.al_status_codes {
        for (i, text) in code.during.iter().enumerate().filter(|(_, text)| !known.contains(text)) {
            let at = code.origin.value(&format!("during.{i}"));
            let message = format!("`{text}` means nothing here");
            let expected = "expected two of the states I, P, B, S and O, as \"PS\", or one of them";
            let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at, expected);
            let letters: String = text.chars().filter(char::is_ascii_alphabetic).collect();
            let meant = known.iter().find(|known| **known == letters.to_ascii_uppercase());
            context.diagnostics.push(match meant {
                Some(meant) => fault.fix(format!("did you mean `{meant}`?"), at, format!("\"{meant}\"")),
                None => fault,
            });
        }
    }
}

/// Times that come again and again.
fn cycles(context: &mut Context<'_>, raw: &RawDevice) {
    let mut times: Vec<(Duration, Location)> = Vec::new();
    for cycle in &raw.cycle_times {
        times.extend(cycle.min.map(|min| (min, cycle.origin.value("min"))));
        let choices = cycle.choices.iter().enumerate();
        times.extend(choices.map(|(i, choice)| (*choice, cycle.origin.value(&format!("choices.{i}")))));
    }
    let configurations = raw.configurations.iter();
    times.extend(configurations.filter_map(|it| Some((it.cycle_time?, it.origin.value("cycle-time")))));
    for mode in &raw.sync_modes {
        let signals = [("sync0", mode.sync0), ("sync1", mode.sync1)];
        let periods = signals.into_iter().filter_map(|(key, signal)| Some((key, signal?.period?)));
        times.extend(periods.map(|(key, period)| (period, mode.origin.value(&format!("{key}.period")))));
    }
    for (_, at) in times.into_iter().filter(|(time, _)| time.0 == 0) {
        let message = "a cycle cannot take no time".to_owned();
        context.fault(&faults::INVALID_VALUE, message, at, "expected more than 0");
    }
}

/// Registers lie in the 64 KiB that a slave controller has.
fn registers(context: &mut Context<'_>, raw: &RawDevice) {
    for register in &raw.registers {
        let (address, length) = (u32::from(register.address), register.length);
        if length == 0 || address + u32::from(length) > 0x1_0000 {
            let message = format!("a register at 0x{address:04X} cannot have {length} bytes");
            let label = format!("expected 1 to {}", 0x1_0000 - address);
            context.fault(&faults::INVALID_VALUE, message, register.origin.value("length"), &label);
        }
    }
}
