//! The shipped descriptions, compiled, and what it takes to hold them against the tables of their manuals.

use std::collections::BTreeSet;
use std::fmt::Debug;
use std::fs;
use std::path::Path;

use devc::lint::Checked;
use devc::model::Family;
use devc::source::Memory;
use devc_tests::manual::Row;

/// The family that `devices/<id>` describes, as its manual prints it: errata say what is printed, but not what holds.
pub(crate) fn family(id: &str) -> Checked<Family> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(id);
    let files =
        fs::read_dir(&folder).expect("the description is there").map(|file| file.expect("a file").path());
    let printed = files.fold(Memory::default(), |memory, file| {
        let text = fs::read_to_string(&file).expect("it can be read");
        let lines = text.lines().filter(|line| !line.starts_with("holds "));
        memory.with(&file, lines.collect::<Vec<_>>().join("\n").into_bytes())
    });
    let compilation = devc::compile(&printed, &folder);
    let messages: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.as_str()).collect();
    compilation.family.unwrap_or_else(|| panic!("{id}: {messages:#?}"))
}

/// The rows of a table of the manual.
pub(crate) fn rows<T: Row>() -> Vec<T> {
    devc_tests::manual::rows().expect("the table can be read")
}

/// Names in one spelling, since the manuals have several.
pub(crate) fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_ascii_alphanumeric()).collect::<String>().to_lowercase()
}

/// What departs from the manual has to be what is known to depart from it: no more, and no less. The second part
/// of what is known is the reason.
pub(crate) fn departs<T: Ord + Debug>(
    found: impl IntoIterator<Item = T>,
    known: impl IntoIterator<Item = (T, &'static str)>,
) {
    let found: BTreeSet<T> = found.into_iter().collect();
    let known: BTreeSet<T> = known.into_iter().map(|(departure, _)| departure).collect();
    let surprising: Vec<_> = found.difference(&known).collect();
    let settled: Vec<_> = known.difference(&found).collect();
    assert!(surprising.is_empty(), "departs from the manual: {surprising:#?}");
    assert!(settled.is_empty(), "departs no longer: {settled:#?}");
}
