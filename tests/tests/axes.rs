//! What objects of several axes name is on the same axis; what is there once names that of each.

#![allow(clippy::expect_used)] // a test may

use std::path::Path;

use devc::emit::markdown::Markdown;
use devc::emit::{Emitter, Options, emit};
use devc::model::{Address, Family, Index};
use devc::source::Memory;
use devc_tests::HEAD;

/// Two axes, 0x800 apart as ETG.6010 has them. Writing 1 to 0x2000 resets the position of both, and to 0x4000 that of its axis.
const TEXT: &str = r#"
[axes]
names     = ["A", "B"]
shifts    = [{ range = "0x4000..=0x47FF", by = 0x800 }, { range = "0x6000..=0x67FF", by = 0x800 }]
pdo-shift = 0x10

[objects.0x2000]
name    = "Reset"
type    = "UINT8"
access  = "rw"
trigger = { value = 1, action = "reset the positions", uses = ["0x2001"], updates = ["0x6064"] }

[objects.0x2001]
name = "Offset"
type = "INT32"

[objects.0x4000]
name    = "Reset of an axis"
type    = "UINT8"
access  = "rw"
trigger = { value = 1, action = "reset the position", uses = ["0x2001", "0x4001"], updates = ["0x6064"] }

[objects.0x4001]
name = "Offset of an axis"
type = "INT32"

[objects.0x6064]
name = "Position actual value"
type = "INT32"
"#;

fn family() -> devc::lint::Checked<Family> {
    let loader = Memory::new().with("device.toml", format!("{HEAD}{TEXT}"));
    let compiled = devc::compile(&loader, Path::new(""));
    let rules: Vec<_> = compiled.diagnostics.iter().map(|one| one.rule.name).collect();
    assert!(!rules.contains(&"differing-axis"), "{rules:?}");
    compiled.family.expect("it compiles")
}

#[test]
fn triggers_reach_their_own_axis_or_all() {
    let family = family();
    let named = |index: u16| {
        let entry = family.members[0].entry(Address { index: Index(index), subindex: 0 }).expect("an entry");
        let trigger = entry.trigger.as_ref().expect("a trigger");
        let indices = |list: &[Address]| list.iter().map(|address| address.index.0).collect::<Vec<_>>();
        (indices(&trigger.uses), indices(&trigger.updates))
    };
    assert_eq!(named(0x2000), (vec![0x2001], vec![0x6064, 0x6864]));
    assert_eq!(named(0x4000), (vec![0x2001, 0x4001], vec![0x6064]));
    assert_eq!(named(0x4800), (vec![0x2001, 0x4801], vec![0x6864]));
}

#[test]
fn the_reference_names_what_each_axis_has_once() {
    let files = emit(&family(), &[&Markdown as &dyn Emitter], &Options::default());
    let text = files.text(".md").expect("Markdown");
    let line = |action: &str| text.lines().find(|line| line.contains(action)).expect("it is told").to_owned();
    let both = line("reset the positions");
    assert!(both.contains("it changes [`0x6064`](#obj-6064) Position actual value of each axis."), "{both}");
    let own = line("reset the position;");
    assert!(own.contains("it changes [`0x6064`](#obj-6064) Position actual value."), "{own}");
}
