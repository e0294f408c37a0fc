//! As text.

use super::{Places, named, range, values};
use crate::diff::change::{Change, Class};
use crate::diff::changes::{Comparison, Versioned};
use crate::source::Sources;
use crate::text::characters::{harmless, line as one_line};

/// A comparison as lines for a terminal: the changes by class, each with its kind, its place, what it was
/// and is, and where both versions say so. `least` is the least class that is listed; of the others there is the number.
pub fn text(comparison: &Comparison, old: &Sources, new: &Sources, least: Class) -> String {
    if comparison.changes.is_empty() {
        return "nothing changes\n".to_owned();
    }
    let places = Places { old, new };
    let mut out: String = comparison.devices.iter().map(heading).collect();
    for class in Class::ALL {
        let changes = comparison.changes.iter().filter(|change| change.kind.class == class);
        let lines: Vec<String> = changes.map(|change| line(comparison, change, &places)).collect();
        match lines.len() {
            0 => {}
            count if class < least => out.push_str(&format!("\n{}: {count}, not listed\n", class.name())),
            count => {
                let title = format!("\n{}: {count}, {}\n", class.name(), class.about());
                out.push_str(&(title + &lines.concat()));
            }
        }
    }
    harmless(&out).into_owned()
}

fn heading(device: &Versioned) -> String {
    let name = one_line(&device.name);
    match device.revisions {
        Some((old, new)) if old != new => format!("{name}, revision 0x{old:08X} → 0x{new:08X}\n"),
        Some((old, _)) => format!("{name}, revision 0x{old:08X} in both versions\n"),
        None => format!("{name}, in one version only\n"),
    }
}

fn line(comparison: &Comparison, change: &Change, places: &Places<'_>) -> String {
    let name = named(change).map_or(String::new(), |name| format!(" {}", one_line(name)));
    let range = range(comparison, change, ", ");
    let range = one_line(&range);
    let values = values(change, "→");
    let values = if values.is_empty() { values } else { format!(": {values}") };
    let (old, new) = places.of(change);
    let places: Vec<String> = [old, new].into_iter().flatten().collect();
    format!(
        "  {} {}{name}{range}{values}\n      {}\n",
        change.kind.rule.name,
        change.at,
        one_line(&places.join(" → "))
    )
}
