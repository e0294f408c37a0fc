//! Each output of a small drive, as a whole: what changes in it is seen when it changes.

#![cfg(test)]

use std::path::Path;

use devc::emit;
use devc::source::Disk;

#[test]
fn outputs_are_as_they_were() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots/device.toml");
    let compilation = devc::compile(&Disk, &path);
    let messages: Vec<_> = compilation.diagnostics.iter().map(|message| message.message.as_str()).collect();
    assert!(messages.is_empty(), "the drive has no fault: {messages:?}");
    let family = compilation.family.expect("the description compiles");
    let names: Vec<_> = emit::ALL.iter().map(|emitter| emitter.name()).collect();
    assert_eq!(names.len(), 4, "all outputs are compared: {names:?}");
    for emitter in emit::ALL {
        insta::assert_snapshot!(
            format!("tiny.{}", emitter.name()),
            emitter.emit(&family, &devc::emit::Options::default())
        );
    }
}
