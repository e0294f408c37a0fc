//! Lines with a key: in order, and with their equals signs below each other.

use super::lead::Lead;
use super::order;
use super::value::Printer;
use crate::written::Item;

/// A key with its value, and what stands around it.
pub(super) struct Line<'t, 'w> {
    pub(super) lead: Lead<'t>,
    pub(super) item: &'w Item,
    /// A comment behind it, with the space before it.
    pub(super) trail: String,
}

/// Prints the lines of a table.
pub(super) fn print(mut lines: Vec<Line<'_, '_>>, printer: &Printer<'_>, out: &mut String) {
    let keys = order::keys(printer.shape());
    let mut rest = lines.as_mut_slice();
    while !rest.is_empty() {
        let others = rest.iter().skip(1);
        let length = 1 + others.take_while(|line| !line.lead.parts()).count();
        let (group, behind) = rest.split_at_mut(length);
        sort(group, &keys);
        print_group(group, printer, out);
        rest = behind;
    }
}

/// Puts the lines of a group in order. A comment above the first may be about all of them, so then it stays the first.
fn sort(group: &mut [Line<'_, '_>], keys: &[&str]) {
    let key = |line: &Line<'_, '_>| order::rank(keys, &line.item.path);
    let Some(first) = group.first() else { return };
    let stays = group.iter().all(|line| key(first) <= key(line));
    if !stays && !first.lead.is_blank() {
        return;
    }
    let lead = group.first_mut().map(|line| std::mem::take(&mut line.lead)).unwrap_or_default();
    group.sort_by_key(key);
    if let Some(first) = group.first_mut() {
        first.lead = lead.joined(std::mem::take(&mut first.lead));
    }
}

fn print_group(group: &[Line<'_, '_>], printer: &Printer<'_>, out: &mut String) {
    let keys: Vec<String> = group.iter().map(|line| printer.key(&line.item.path)).collect();
    let single = group.iter().zip(&keys).filter(|(line, _)| line.item.path.len() == 1);
    let width = single.map(|(_, key)| key.chars().count()).max().unwrap_or_default();
    for (line, key) in group.iter().zip(&keys) {
        line.lead.print(out);
        let pad = if line.item.path.len() == 1 { width.saturating_sub(key.chars().count()) } else { 0 };
        let (pad, value) = (" ".repeat(pad), printer.of(line.item));
        out.push_str(&format!("{key}{pad} = {value}{}\n", line.trail));
    }
}
