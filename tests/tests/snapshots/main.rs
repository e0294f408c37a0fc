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
    for emitter in emit::ALL {
        for (name, content) in emitter.emit(&family, &emit::Options::default()).0 {
            let (_, end) = name.rsplit_once('.').expect("a name with an end");
            // what is bytes, and what is mostly a script, has readers of its own among the tests
            let is_text = !["hex", "html"].contains(&end);
            let Some(text) = String::from_utf8(content).ok().filter(|_| is_text) else { continue };
            // one in a folder of its own is told by its whole name
            let end = name.rsplit_once('/').map_or(end, |(_, file)| file);
            insta::assert_snapshot!(format!("tiny.{end}"), text);
        }
    }
}
