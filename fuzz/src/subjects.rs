//! Descriptions to begin with: those that are shipped, those that other tests have for what none of them has, and the
//! examples of all rules.

#[path = "../../compiler/tests/rules/example.rs"]
#[expect(dead_code, reason = "only the files of examples are of use here")]
mod example;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use devc::Compilation;
use devc::diagnostic::faults;
use devc::lint;
use devc::source::Memory;

/// The files of a description by name.
pub(crate) type Files = BTreeMap<String, String>;

/// Folders and files with descriptions.
const PLACES: &[&str] = &[
    "devices/c887",
    "devices/pmc-sc6",
    "devices/s700",
    "compiler/tests/hundred",
    "tests/tests/consumers/corner",
    "tests/tests/esi/corners.toml",
    "tests/tests/esi/wired/five_managers.toml",
    "tests/tests/facts/base.toml",
    "tests/tests/facts/members.toml",
    "tests/tests/rust/bounded",
    "tests/tests/rust/geared",
    "tests/tests/rust/mapped",
    "tests/tests/rust/widths",
    "tests/tests/sii/corner.toml",
];

/// All of them; those that are shipped are the first [`SHIPPED`].
pub(crate) static ALL: LazyLock<Vec<Files>> = LazyLock::new(|| {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let rules = faults::ALL.iter().copied().chain(lint::ALL.iter().map(|lint| lint.rule));
    let examples = rules.flat_map(|rule| {
        ["Fires", "Silent"].into_iter().filter_map(|heading| example::example(rule.docs, heading))
    });
    let examples = examples.map(|text| example::files(text).into_iter().collect());
    PLACES.iter().map(|place| read(&root.join(place))).chain(examples).collect()
});

/// How many are shipped; they are larger than all others.
pub(crate) const SHIPPED: usize = 3;

/// All words that stand in them.
pub(crate) static WORDS: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ':');
    let texts = ALL.iter().flat_map(BTreeMap::values);
    let words = texts.flat_map(|text| text.split(move |c| !is_part(c))).filter(|word| !word.is_empty());
    words.collect::<BTreeSet<_>>().into_iter().collect()
});

fn read(place: &Path) -> Files {
    let mut files: Vec<PathBuf> = if place.is_dir() {
        let entries = fs::read_dir(place).expect("a folder").map(|entry| entry.expect("an entry").path());
        entries.filter(|path| path.extension().is_some_and(|extension| extension == "toml")).collect()
    } else {
        vec![place.to_owned()]
    };
    files.sort();
    let is_alone = files.len() == 1;
    let name = |path: &Path| {
        if is_alone {
            return "device.toml".to_owned();
        }
        path.file_name().expect("a name").to_string_lossy().into_owned()
    };
    files.iter().map(|path| (name(path), fs::read_to_string(path).expect("a text"))).collect()
}

/// A subject by any number; most of those that are asked for are small.
pub(crate) fn subject(number: u16) -> &'static Files {
    &ALL[usize::from(number) % ALL.len()]
}

/// A subject that is not shipped, for what compiles more than once.
pub(crate) fn small(number: u16) -> &'static Files {
    &ALL[SHIPPED + usize::from(number) % (ALL.len() - SHIPPED)]
}

pub(crate) fn compile(files: &Files) -> Compilation {
    let memory = files.iter().fold(Memory::new(), |memory, (name, text)| {
        memory.with(Path::new("drive").join(name), text.as_str())
    });
    devc::compile(&memory, Path::new("drive"))
}
