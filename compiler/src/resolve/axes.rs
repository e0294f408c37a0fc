//! Axes and the ranges of the dictionary that they repeat.

use std::collections::BTreeMap;

use super::context::Context;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Axis, Index, Shift};
use crate::raw::RawAxes;
use crate::source::keys;

/// The axes of a device; one without a name if the description lists none.
pub(super) fn axes(raw: Option<&RawAxes>) -> Vec<Axis> {
    let names = raw.map(|axes| &axes.names[..]).filter(|names| !names.is_empty());
    let Some(names) = names else { return vec![Axis { number: 0, name: String::new(), about: None }] };
    let abouts = raw.map(|axes| &axes.about[..]).unwrap_or_default();
    let numbered = (0..=u8::MAX).zip(names);
    numbered
        .map(|(number, name)| Axis {
            number,
            name: name.clone(),
            about: abouts.get(usize::from(number)).cloned(),
        })
        .collect()
}

/// The ranges that exist once for each axis; each must have room for all of them.
pub(super) fn shifts(context: &mut Context<'_>, raw: Option<&RawAxes>) -> Vec<Shift> {
    let Some(raw) = raw else { return Vec::new() };
    report_names(context, raw);
    let mut shifts = Vec::new();
    for (i, shift) in raw.shifts.iter().enumerate() {
        let at = raw.origin.value(&format!("shifts.{i}.range"));
        let Some(range) = keys::range::<u16>(&shift.range) else {
            context.invalid(&shift.range, "a range of indices such as \"0x6000..=0x67FF\"", at);
            continue;
        };
        let (first, last) = range.into_inner();
        let shift = Shift { first: Index(first), last: Index(last), by: shift.by };
        match collision(&shift, context.axes.len()) {
            None => shifts.push(shift),
            Some((message, label)) => {
                let by = raw.origin.value(&format!("shifts.{i}.by"));
                let fault = Diagnostic::new(&faults::COLLIDING_AXES, message, by, label);
                context.diagnostics.push(fault.label(at, "the range of the first axis"));
            }
        }
    }
    shifts
}

/// Reports axes that have no number or no name of their own.
fn report_names(context: &mut Context<'_>, raw: &RawAxes) {
    let at = |i: usize| raw.origin.value(&format!("names.{i}"));
    let count = raw.names.len();
    if count > context.axes.len().max(1) {
        let message = format!("{count} axes are more than the 256 that devc can number");
        let first = at(context.axes.len());
        return context.fault(&faults::INVALID_VALUE, message, first, "the first without a number");
    }
    if raw.about.len() > count {
        let message = format!("`about` tells of {} axes, but there are {count}", raw.about.len());
        let at = raw.origin.value(&format!("about.{count}"));
        context.fault(&faults::INVALID_VALUE, message, at, "the first without an axis");
    }
    let mut first: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, name) in raw.names.iter().enumerate() {
        if let Some(other) = first.get(name.as_str()) {
            let message = format!("two axes are called `{name}`");
            let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at(i), "this axis");
            context.diagnostics.push(fault.label(at(*other), "and this one"));
        }
        first.entry(name).or_insert(i);
    }
}

/// Why the axes would collide under a shift, if they would.
fn collision(shift: &Shift, axes: usize) -> Option<(String, String)> {
    let span = u32::from(shift.last.0) - u32::from(shift.first.0) + 1;
    let by = u32::from(shift.by);
    if axes > 1 && by < span {
        let message = format!("axes 0x{by:X} apart share indices: each has 0x{span:X} of them");
        return Some((message, format!("0x{span:X} or more keeps them apart")));
    }
    let last = u32::from(shift.last.0) + by * u32::try_from(axes.saturating_sub(1)).unwrap_or(u32::MAX);
    (last > 0xFFFF).then(|| {
        (
            format!("the last of {axes} axes would end at 0x{last:X}"),
            "the dictionary ends at 0xFFFF".to_owned(),
        )
    })
}
