//! Descriptions that are written in short, as in the docs of rules.

use std::path::Path;

use devc::Compilation;
use devc::diagnostic::render::{Style, text};
use devc::lint;
use devc::source::Memory;

/// What every example is completed with, unless it brings its own.
const HEAD: &str = "\n[device]\nname = \"Example\"\nvendor = \"Example\"\n";
const IDENTITY: &str = "\n[identity]\nvendor-id = 0x76D\nproduct-code = 3\nrevision = 1\n";

/// What the slave controller starts with.
const EEPROM: &str = "\n[eeprom]\nsize = 16384\nconfig-data = \"050E03EE0000\"\n";

/// What carries mail and process data.
const SYNC_MANAGERS: &str = "
[sync-managers]
mailbox-out = { address = 0x1000, size = 128 }
mailbox-in = { address = 0x1080, size = 128 }
outputs = { address = 0x1100 }
inputs = { address = 0x1800 }
";

/// The example under a heading.
pub(crate) fn example<'d>(docs: &'d str, heading: &str) -> Option<&'d str> {
    let (_, section) = docs.split_once(&format!(" ## {heading}\n"))?;
    let (_, fence) = section.split_once("```toml\n")?;
    fence.split_once(" ```").map(|(example, _)| example)
}

/// The files of an example: the main one, and those that a line `# file: name` starts.
pub(crate) fn files(example: &str) -> Vec<(String, String)> {
    let lines = example.lines().map(|line| line.strip_prefix(' ').unwrap_or(line));
    let mut file = ("device.toml".to_owned(), String::new());
    let mut files = Vec::new();
    for line in lines {
        match line.strip_prefix("# file: ") {
            Some(name) => files.push(std::mem::replace(&mut file, (name.to_owned(), String::new()))),
            None => {
                file.1.push_str(line);
                file.1.push('\n');
            }
        }
    }
    files.push(file);
    let whole: String = files.iter().map(|(_, text)| text.as_str()).collect();
    let missing = [("[device]", HEAD), ("[identity]", IDENTITY), ("[eeprom]", EEPROM)];
    let carried = ["[rx-pdos", "[tx-pdos", "[mailbox]"].into_iter().any(|header| whole.contains(header));
    let managers = carried.then_some(("[sync-managers", SYNC_MANAGERS));
    let missing = missing.into_iter().chain(managers).filter(|(header, _)| !whole.contains(header));
    files.iter_mut().take(1).for_each(|(_, main)| main.extend(missing.clone().map(|(_, text)| text)));
    files
}

/// What devc says of an example for a rule, which is asked even if it is about an output that is not made of itself.
pub(crate) fn compiled(of: &str, example: &str) -> Compilation {
    let memory = files(example).into_iter().fold(Memory::default(), |memory, (name, text)| {
        memory.with(Path::new("example").join(name), text.into_bytes())
    });
    let mut outputs = devc::emit::lints(devc::emit::default());
    outputs.extend(lint::ALL.iter().map(|lint| lint.rule).filter(|rule| rule.name == of));
    let request = devc::Request { outputs, ..devc::Request::default() };
    devc::compile_with(&memory, Path::new("example"), &request, &mut |_| ())
}

/// The rules that fire on an example.
pub(crate) fn fired(of: &str, example: &str) -> Vec<&'static str> {
    let diagnostics = compiled(of, example).diagnostics;
    let mut names: Vec<&str> = diagnostics.iter().map(|diagnostic| diagnostic.rule.name).collect();
    names.dedup();
    names
}

/// The messages about an example as people read them.
pub(crate) fn messages(of: &str, example: &str) -> Vec<String> {
    let Compilation { diagnostics, sources, .. } = compiled(of, example);
    diagnostics.iter().map(|diagnostic| text(diagnostic, &sources, Style::Plain)).collect()
}
