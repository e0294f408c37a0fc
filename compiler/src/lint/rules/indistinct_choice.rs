use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Compare, Device, FieldPath, Section, differences};
use crate::source::Origin;

rule! {
    /// Ways to keep time with the clocks, and configurations, are what people choose among. If two are the same but for their
    /// names, nobody can tell which to take, and it makes no difference: one was copied, and what it should have of its own was
    /// forgotten. What differs in the device only is said in `about`.
    ///
    /// Without the clocks, ways to keep time can differ by what the device makes of them: free run, or synchronous with the
    /// sync manager.
    ///
    /// ## Fires
    /// ```toml
    /// [objects]
    /// 0x1C32 = { name = "Outputs", type = "UINT16" }
    /// 0x1C33 = { name = "Inputs", type = "UINT16" }
    ///
    /// [sync-modes]
    /// dc = { name = "DC", assign-activate = 0x300, sync0 = { cycles = 1 } }
    /// shifted = { name = "DC, shifted", assign-activate = 0x300, sync0 = { cycles = 1 } }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects]
    /// 0x1C32 = { name = "Outputs", type = "UINT16" }
    /// 0x1C33 = { name = "Inputs", type = "UINT16" }
    ///
    /// [sync-modes]
    /// dc = { name = "DC", assign-activate = 0x300, sync0 = { cycles = 1 } }
    /// shifted = { name = "DC, shifted", assign-activate = 0x300, sync0 = { cycles = 1, shift = "20 us" } }
    /// ```
    pub(super) static RULE = "indistinct-choice", Facts, Warning, "two choices are the same but for their names";
}

/// What names a choice, or follows from the others: it does not matter which is chosen.
const BESIDE: [&str; 5] = ["id", "name", "default", "source", "startup"];

pub(super) fn check(device: &Device, report: &mut Report) {
    let modes = device.sync_modes.iter().filter(|mode| mode.assign_activate != 0);
    let modes = modes.map(|mode| (&*mode.id, mode, &mode.origin)).collect();
    judge(Section::SyncModes, modes, report);
    let configurations = device.configurations.iter().filter(|it| it.chooses_anything());
    let configurations = configurations.map(|it| (&*it.id, it, &it.origin)).collect();
    judge(Section::Configurations, configurations, report);
}

fn judge<T: Compare>(section: Section, choices: Vec<(&str, &T, &Origin)>, report: &mut Report) {
    let Some((_, reference, _)) = choices.first() else { return };
    // what is the same differs from a third in the same; so each is compared with two others at most
    let mut known: BTreeMap<Vec<Differing>, (&str, &T, &Origin)> = BTreeMap::new();
    for (id, choice, origin) in &choices {
        let (other, first) = match known.entry(differing(*reference, *choice)) {
            Entry::Vacant(vacant) => {
                vacant.insert((id, choice, origin));
                continue;
            }
            Entry::Occupied(occupied) => match *occupied.get() {
                (other, same, first) if differing(same, *choice).is_empty() => (other, first),
                _ => continue,
            },
        };
        let message = format!("`{id}` and `{other}` are the same but for their names");
        let diagnostic = Diagnostic::new(&RULE, message, origin.header(), "the same again")
            .label(first.header(), "first here")
            .help("say in what they differ, in `about` if nothing else tells it, or leave one of them out");
        report.push(section.at(id), diagnostic);
    }
}

/// Where a choice differs from another, and what it has there.
type Differing = (FieldPath, Option<String>);

/// What differs in a choice from another one but its name.
fn differing<T: Compare>(other: &T, choice: &T) -> Vec<Differing> {
    let differing = differences(other, choice).into_iter();
    let of_choice = |path: &FieldPath| path.0.first().is_none_or(|field| !BESIDE.contains(&&**field));
    differing.filter(|it| of_choice(&it.path)).map(|it| (it.path, it.second)).collect()
}
