//! Who may look to whom.

use std::collections::{BTreeMap, BTreeSet};

use crate::Fault;
use crate::modules::{Module, Modules, Name};

/// The order that a document states: names with `<` between them, as code.
pub(crate) fn stated(document: &str) -> Option<Vec<String>> {
    let order = document.split('`').find(|code| code.contains(" < "))?;
    Some(order.split('<').map(|name| name.trim().to_owned()).collect())
}

/// The modules that the order leaves out, and those in it that there are not.
pub(crate) fn unlisted(modules: &Modules, order: &[String]) -> Vec<Fault> {
    let there: BTreeSet<&String> = modules.keys().filter_map(|name| name.first()).collect();
    let listed: BTreeSet<&String> = order.iter().collect();
    let odd = there.symmetric_difference(&listed);
    let fault = |name: &&String| {
        let what = format!("the order of the modules and the modules differ in `{name}`");
        Fault { file: "compiler/docs/architecture.md".to_owned(), line: 1, what }
    };
    odd.map(fault).collect()
}

/// Where a module looks to one above it.
pub(crate) fn upward(modules: &Modules, order: &[String]) -> Vec<Fault> {
    let rank = |name: &Name| order.iter().position(|listed| Some(listed) == name.first());
    let faults = modules.iter().flat_map(|(name, module)| {
        let above =
            module.looks.iter().filter(move |(target, _)| rank(target) > rank(name) && rank(name).is_some());
        above.map(|(target, line)| fault(module, *line, format!("looks up to `{}`", target.join("::"))))
    });
    faults.collect()
}

fn fault(module: &Module, line: usize, what: String) -> Fault {
    Fault { file: module.file.clone(), line, what }
}

/// Where modules of one folder look to each other, be it by way of others. What the folder's own file holds for all of
/// them is no circle.
pub(crate) fn circles(modules: &Modules) -> Vec<Fault> {
    let folders: BTreeSet<&[String]> =
        modules.keys().flat_map(|name| (0..name.len()).map(|length| &name[..length])).collect();
    folders.into_iter().flat_map(|folder| circles_in(folder, modules)).collect()
}

fn circles_in(folder: &[String], modules: &Modules) -> Vec<Fault> {
    let child = |name: &Name| name.strip_prefix(folder).and_then(|rest| rest.first()).cloned();
    let mut looks = Vec::new();
    for (name, module) in modules {
        for (target, line) in &module.looks {
            if let (Some(from), Some(to)) = (child(name), child(target)) {
                looks.push((from, to, module, *line));
            }
        }
    }
    let mut reached: BTreeMap<&String, BTreeSet<&String>> = BTreeMap::new();
    for (from, to, ..) in &looks {
        reached.entry(from).or_default().insert(to);
    }
    while grow(&mut reached) {}
    let in_circle = looks
        .iter()
        .filter(|(from, to, ..)| from != to && reached.get(to).is_some_and(|beyond| beyond.contains(from)));
    in_circle
        .map(|(_, to, module, line)| fault(module, *line, format!("looks in a circle to `{to}`")))
        .collect()
}

/// Adds to what each reaches what is reached from there, and says whether that was news.
fn grow(reached: &mut BTreeMap<&String, BTreeSet<&String>>) -> bool {
    let known = reached.clone();
    let mut has_grown = false;
    for places in reached.values_mut() {
        let before = places.len();
        let beyond: Vec<&String> =
            places.iter().filter_map(|place| known.get(place)).flatten().copied().collect();
        places.extend(beyond);
        has_grown |= places.len() > before;
    }
    has_grown
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::code::Code;
    use crate::modules::read;

    fn modules(files: &[(&str, &str)]) -> Modules {
        let files: Vec<Code> =
            files.iter().map(|(name, text)| Code::new(&Path::new("x/src").join(name), text)).collect();
        read(&files)
    }

    fn said(faults: Vec<Fault>) -> Vec<String> {
        faults.iter().map(Fault::to_string).collect()
    }

    #[test]
    fn looking_up_is_found_however_it_is_written() {
        let order = stated("first `a`, then `low < high`.").expect("an order");
        let files = [
            ("lib.rs", "pub use high::Top;"),
            ("low.rs", "use std::fmt;\nuse crate::{Top, low::x};"),
            ("low/x.rs", "fn f() { super::super::high::g(); }"),
            ("low/y.rs", "use super::z;\nuse super::x::h;"),
            ("high.rs", "use crate::low;"),
        ];
        assert_eq!(
            said(upward(&modules(&files), &order)),
            ["x/src/low.rs:2: looks up to `high`", "x/src/low/x.rs:1: looks up to `high`"]
        );
        assert_eq!(said(unlisted(&modules(&files), &order)), [""; 0]);
        assert_eq!(unlisted(&modules(&files), &order[..1]).len(), 1);
    }

    #[test]
    fn circles_are_found_behind_what_is_exported() {
        let files = [
            ("lib.rs", ""),
            ("a/mod.rs", "pub use x::X;\npub struct Shared;"),
            ("a/x.rs", "use super::y::Y;\nuse super::Shared;"),
            ("a/y.rs", "use super::X;"),
            ("a/z.rs", "use super::{Shared, y};"),
        ];
        assert_eq!(
            said(circles(&modules(&files))),
            ["x/src/a/x.rs:1: looks in a circle to `y`", "x/src/a/y.rs:1: looks in a circle to `x`"]
        );
    }
}
