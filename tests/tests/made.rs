//! What devc makes of the dictionary: mapping and assignment objects (ETG.1000.6, 5.6.7.4), names that are left out, what can be
//! mapped, and how far axes go.

#![allow(clippy::expect_used, clippy::indexing_slicing)] // a test may

use std::path::Path;

use devc::model::{Access, Device, Direction, Index, Object};
use devc::source::Memory;
use devc_tests::HEAD;

fn compiled(text: &str) -> Result<Device, Vec<String>> {
    let loader = Memory::new().with("device.toml", format!("{HEAD}{text}"));
    let compilation = devc::compile(&loader, Path::new(""));
    let messages = compilation.diagnostics.iter().map(|one| one.message.clone());
    match compilation.family {
        Some(family) => Ok(family.members[0].clone()),
        None => Err(messages.collect()),
    }
}

fn device(text: &str) -> Device {
    compiled(text).expect("it compiles")
}

fn object(device: &Device, index: u16) -> &Object {
    device.object(Index(index)).expect("the dictionary has it")
}

fn names(device: &Device, index: u16) -> Vec<&str> {
    object(device, index).entries.iter().map(|entry| entry.name.as_str()).collect()
}

const MANAGERS: &str = r#"
[mailbox]
protocols = ["CoE"]
pdo-config = true
pdo-assign = true
[sync-managers.outputs]
address = 0x1800
max-size = 4
pdos = ["0x1600"]
[sync-managers.inputs]
address = 0x1C00
pdos = []
[objects]
0x2000 = { name = "Narrow", type = "UINT8", access = "rw", pdo = "rx" }
0x2001 = { name = "Wide", type = "UINT32", access = "rw", pdo = "rx" }
0x2002 = { name = "Middle", type = "UINT16", access = "rw", pdo = "rx" }
0x2003 = { name = "Second", type = "UINT16", access = "rw", pdo = "rx" }
0x2004 = { name = "Third", type = "UINT16", access = "rw", pdo = "rx" }
0x2005 = { name = "Inside", type = "UINT16", access = "rw" }
"#;

#[test]
fn a_free_mapping_has_room_for_what_fits() {
    let places = |keys: &str| {
        let pdo = format!("[rx-pdos.0x1600]\nname = \"Values\"\nentries = [\"0x2000\"]\n{keys}");
        names(&device(&format!("{MANAGERS}{pdo}")), 0x1600).len() - 1
    };
    assert_eq!(places("fixed = true"), 1);
    assert_eq!(places("fixed = false"), 4, "bytes of the sync manager, of which the narrowest takes one");
    assert_eq!(places("fixed = false\nmax-bytes = 2"), 2);
    assert_eq!(places("fixed = false\nmax-bytes = 100"), 4);
    assert_eq!(places("fixed = false\nmax-entries = 3"), 3);
    let wide = MANAGERS.replace("max-size = 4", "max-size = 400");
    let pdo = "[rx-pdos.0x1600]\nname = \"Values\"\nfixed = false\nentries = [\"0x2000\"]\n";
    assert_eq!(names(&device(&format!("{wide}{pdo}")), 0x1600).len() - 1, 5, "each object once");
}

#[test]
fn what_a_fixed_mapping_maps_gives_its_names() {
    let pdo =
        |fixed: bool| format!("[rx-pdos.0x1600]\nname = \"V\"\nfixed = {fixed}\nentries = [\"0x2001\"]\n");
    let fixed = device(&format!("{MANAGERS}{}", pdo(true)));
    assert_eq!(names(&fixed, 0x1600)[1], "Wide");
    assert_eq!(object(&fixed, 0x1600).entries[1].access, Access::Ro);
    let free = device(&format!("{MANAGERS}{}", pdo(false)));
    assert_eq!(names(&free, 0x1600)[1], "SubIndex 001");
    assert_eq!(object(&free, 0x1600).entries[1].access, Access::Rw);
    let kept = MANAGERS.replace("pdo-config = true", "pdo-config = false");
    let kept = device(&format!("{kept}{}", pdo(false)));
    assert_eq!(object(&kept, 0x1600).entries[1].access, Access::Ro);
}

/// The assignment of a sync manager that carries no PDOs is there only if a description says so.
#[test]
fn assignment_objects_that_carry_nothing() {
    let pdo = "[rx-pdos.0x1600]\nname = \"V\"\nentries = [\"0x2001\"]\n";
    let said = device(&format!("{MANAGERS}{pdo}[objects.0x1C15]\nabout = \"Nothing is in it.\"\n"));
    let made = object(&said, 0x1C15);
    assert_eq!((made.name.as_str(), made.entries.len()), ("Sync manager 5 PDO assignment", 1));
    assert_eq!(made.about.as_deref(), Some("Nothing is in it."));
    let whole = format!(
        "{MANAGERS}{pdo}[objects.0x1C15]\nname = \"Own\"\nentries = {{ 1 = {{ name = \"One\", type = \"UINT16\" }} }}\n"
    );
    let whole = device(&whole);
    assert_eq!(names(&whole, 0x1C15), ["Highest subindex supported", "One"]);
    let alone = device(
        "[objects.0x1C00]\nname = \"Types\"\nentries = { 1 = { name = \"First\", type = \"UINT8\" } }\n",
    );
    assert_eq!((alone.objects.len(), names(&alone, 0x1C00)[1]), (1, "First"));
}

#[test]
fn what_an_entry_does_not_say_is_its_own() {
    let text = r#"
[objects.0x2000]
name      = "Gains"
parameter = "P{}"
source    = "p. 1"
entries.0 = { source = "p. 1" }
entries.1 = { type = "UINT16", source = "p. 2" }
entries.2 = { type = "UINT16", values = "second", source = "p. 1" }
[enumerations.first]
values = { 1 = "a" }
[enumerations.second]
values = { 1 = "b" }
"#;
    let device = device(text);
    assert_eq!(names(&device, 0x2000), ["Highest subindex supported", "Subindex 001", "Subindex 002"]);
    let entries = &object(&device, 0x2000).entries;
    let parameters: Vec<_> = entries.iter().map(|entry| entry.parameter.as_deref()).collect();
    assert_eq!(parameters, [None, Some("P1"), Some("P2")]);
    let sources: Vec<_> = entries.iter().map(|entry| entry.source.as_ref().map(|it| &*it.place)).collect();
    assert_eq!(sources, [None, Some("p. 2"), None], "what all have stands at the object");
    assert_eq!(entries[2].values.iter().map(|it| &*it.name).collect::<Vec<_>>(), ["b"]);
}

#[test]
fn what_can_be_mapped_without_a_word_of_it() {
    let goes = |text: &str, index: u16| {
        let device = device(text);
        let pdo = object(&device, index).entries[0].pdo;
        [Direction::Rx, Direction::Tx].map(|way| pdo.goes(way))
    };
    let profile = "profiles = [\"cia402\"]\n";
    let alone = format!("{profile}[objects.0x6040]\n");
    let without = compiled_with_profile(&alone);
    assert!(without.object(Index(0x6040)).expect("it is there").entries[0].pdo.goes(Direction::Rx));
    let early = compiled_with_profile(&format!("{alone}written = \"pre-op\"\n"));
    let pdo = early.object(Index(0x6040)).expect("it is there").entries[0].pdo;
    assert!(!pdo.goes(Direction::Rx), "outputs come in Operational, when it is no longer taken");
    let free = "[rx-pdos.0x1600]\nname = \"V\"\nfixed = false\nentries = [\"0x2001\"]\n";
    assert_eq!(goes(&format!("{MANAGERS}{free}"), 0x2005), [false, false]);
    let fixed = "[rx-pdos.0x1600]\nname = \"V\"\nfixed = true\nentries = [\"0x2005\"]\n";
    assert_eq!(goes(&format!("{MANAGERS}{fixed}"), 0x2005), [true, false]);
}

/// A profile is named before the first table.
fn compiled_with_profile(text: &str) -> Device {
    let (profile, rest) = text.split_once('\n').expect("two lines");
    let loader = Memory::new().with("device.toml", format!("{profile}\n{HEAD}{rest}"));
    devc::compile(&loader, Path::new("")).family.expect("it compiles").members[0].clone()
}

#[test]
fn axes_end_where_the_dictionary_does() {
    let axes = |names: &str, range: &str, by: &str| {
        compiled(&format!("[axes]\nnames = [{names}]\nshifts = [{{ range = \"{range}\", by = {by} }}]\n"))
    };
    let two = r#""A", "B""#;
    assert!(axes(two, "0x2000..=0x7FFF", "0x8000").is_ok(), "the last ends at 0xFFFF");
    assert_eq!(axes(two, "0x2000..=0x8000", "0x8000").expect_err("it ends behind it").len(), 1);
    assert!(axes(two, "0x6000..=0x67FF", "0x800").is_ok());
    assert_eq!(axes(two, "0x6000..=0x67FF", "0x7FF").expect_err("they share one").len(), 1);
    assert!(axes(r#""A""#, "0x6000..=0x67FF", "0x7FF").is_ok(), "one shares with none");
    let told = |about: &str| compiled(&format!("[axes]\nnames = [{two}]\nabout = [{about}]\n"));
    assert!(told(r#""Of A.""#).is_ok());
    assert!(told(r#""Of A.", "Of B.""#).is_ok());
    assert_eq!(told(r#""Of A.", "Of B.", "Of C.""#).expect_err("there is no third").len(), 1);
}

/// ETG.2000: a letter for each port; devc writes them as the schema has them.
#[test]
fn ports_are_capital_letters() {
    let suggested = |physics: &str| {
        let head = HEAD.replace("[identity]", &format!("physics = \"{physics}\"\n[identity]"));
        let compilation = devc::compile(&Memory::new().with("device.toml", head), Path::new(""));
        let edits = compilation.diagnostics.iter().flat_map(|one| &one.helps).flat_map(|help| &help.edits);
        edits.map(|edit| edit.text.clone()).collect::<Vec<_>>()
    };
    assert_eq!(suggested("yk"), ["\"YK\""]);
    assert_eq!(suggested("u8"), Vec::<String>::new());
    assert_eq!(suggested("QQ"), Vec::<String>::new());
}

#[test]
fn registers_end_where_the_controller_does() {
    let register = |address: &str, length: u16| {
        let row = format!("name = \"R\"\nlength = {length}\necat = \"r\"\ndrive = \"r\"");
        compiled(&format!("[registers.{address}]\n{row}\n"))
    };
    assert!(register("0xFFFE", 2).is_ok());
    assert_eq!(register("0xFFFE", 3).expect_err("one byte too many").len(), 1);
    assert_eq!(register("0x0100", 0).expect_err("no byte").len(), 1);
}

#[test]
fn a_text_is_written_as_its_letters() {
    let text = r#"
[mailbox]
protocols = ["CoE"]
[objects.0x2000]
name   = "Label"
type   = "STRING(4)"
access = "rw"
[configurations.named]
name   = "Named"
writes = [{ entry = "0x2000", value = "AB", why = "to find it" }]
"#;
    let device = device(text);
    let write = device.configurations[0].startup.iter().find(|it| it.address.index.0 == 0x2000);
    assert_eq!(write.expect("it is written").data, b"AB");
}

/// Assignments are cleared, then filled and counted (ETG.1020). What belongs to the way to Pre-Operational comes before.
#[test]
fn a_device_that_tells_of_no_sync_manager_is_assigned_as_usual() {
    let text = r#"
[mailbox]
protocols  = ["CoE"]
pdo-assign = true
[objects]
0x2000 = { name = "Speed", type = "UINT16", access = "rw", pdo = "rx-tx" }
0x2001 = { name = "Key", type = "UINT16", access = "rw" }
[rx-pdos.0x1600]
name = "Target"
entries = ["0x2000"]
[tx-pdos.0x1A00]
name = "Actual"
entries = ["0x2000"]
[configurations.both]
name    = "Both"
outputs = ["0x1600"]
inputs  = ["0x1A00"]
writes  = [
    { entry = "0x2000", value = 2, why = "later" },
    { entry = "0x2001", value = 1, transition = "IP", why = "first" },
]
"#;
    let device = device(text);
    let list = &device.configurations[0].startup;
    let places: Vec<_> = list.iter().map(|it| (it.address.index.0, it.address.subindex)).collect();
    let filled = [(0x1C12, 1), (0x1C12, 0), (0x1C13, 1), (0x1C13, 0)];
    let expected = [(0x2001, 0), (0x1C12, 0), (0x1C13, 0)].into_iter().chain(filled).chain([(0x2000, 0)]);
    assert_eq!(places, expected.collect::<Vec<_>>());
}

#[test]
fn pdos_of_axes_end_where_their_direction_does() {
    let pdo = |index: &str| {
        compiled(&format!(
            r#"
[axes]
names     = ["A", "B"]
shifts    = [{{ range = "0x6000..=0x67FF", by = 0x800 }}]
pdo-shift = 0x10
[objects.0x6000]
name   = "Speed"
type   = "UINT16"
access = "rw"
pdo    = "rx"
[rx-pdos.{index}]
name     = "Target"
per-axis = true
entries  = ["0x6000"]
"#
        ))
    };
    assert!(pdo("0x17EF").is_ok(), "the second axis has the last, 0x17FF");
    assert_eq!(pdo("0x17F0").expect_err("0x1800 is no receive PDO").len(), 1);
}

#[test]
fn what_a_profile_has_is_offered_where_it_is_not_taken() {
    let told = |name: &str| {
        let text = format!(
            "profiles = [\"cia402\"]\n{HEAD}[words.own]\nobject = \"{name}\"\nbits = {{ 0 = \"on\" }}\n"
        );
        let compilation = devc::compile(&Memory::new().with("device.toml", text), Path::new(""));
        let helps = compilation.diagnostics.iter().flat_map(|one| &one.helps).map(|help| help.text.clone());
        let notes = compilation.diagnostics.iter().flat_map(|one| one.notes.clone());
        helps.chain(notes).collect::<Vec<_>>().join(" ")
    };
    assert!(told("controlword").contains("0x6040"), "{}", told("controlword"));
    assert!(told("controlwrod").contains("0x6040"), "{}", told("controlwrod"));
    assert!(told("controlwo").contains("0x6040"), "{}", told("controlwo"));
    assert!(!told("nothing-of-the-kind").contains("0x"), "{}", told("nothing-of-the-kind"));
}
