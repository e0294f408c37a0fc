//! The device type has the profile in its lower half and what the axis is in its upper one, 0xFFFF for several axes (CiA 301,
//! CiA 402); the name and the identity are those of the ESI (ETG.1000.6); slots are told from 0xF000 on (ETG.5001.1).

use std::path::Path;

use crate::compile;
use crate::model::{DataType, Value};
use crate::source::Memory;

const AXIS: &str = "[axes]\nnames = [\"X\"]\nadd-info = 2\n";
const AXES: &str =
    "[axes]\nnames = [\"X\", \"Y\"]\nadd-info = 2\nshifts = [{ range = \"0x6000..=0x67FF\", by = 0x800 }]\n";
const MODULES: &str = "[modules.0x10]\nname = \"Drive X\"\naxes = [\"X\"]\n[modules.0x20]\nname = \"Drive Y\"\naxes = [\"Y\"]\n";

/// The type and the default of an entry of a device with such a profile and such objects.
fn entry(profile: &str, rest: &str, address: &str) -> (DataType, Option<Value>) {
    let text = format!(
        "profiles = [\"ethercat\", \"cia402\"]\nsource = \"p. 1\"\n[device]\nname = \"Drive 7\"\nvendor = \"V\"\n{profile}\
         [identity]\nvendor-id = 0x11\nproduct-code = 0x22\nrevision = 0x33\n{rest}"
    );
    let compilation = compile(&Memory::new().with("x/device.toml", text.clone()), Path::new("x"));
    let said: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.clone()).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{text}: {said:?}"));
    let device = family.members.first().expect("a device");
    let mut entries = device.objects.iter().flat_map(|object| &object.entries);
    let found = entries.find(|entry| entry.address.to_string() == address);
    let found = found.unwrap_or_else(|| panic!("{text}: no {address}"));
    (found.data_type, found.default.clone())
}

fn default(profile: &str, rest: &str, address: &str) -> Option<Value> {
    entry(profile, rest, address).1
}

#[test]
fn the_device_type_is_the_profile_and_what_the_axes_are() {
    const TYPE: &str = "[objects.0x1000]\n";
    for (profile, axes, expected) in [
        ("profile = 402\n", AXIS, Some(0x0002_0192)),
        ("profile = 402\n", AXES, Some(0xFFFF_0192)),
        ("profile = 0xFFFF\n", AXIS, Some(0x0002_FFFF)),
        // what it is, or which profile it follows, is not said, or has no room
        ("profile = 402\n", "", None),
        ("profile = 402\n", "[axes]\nnames = [\"X\"]\n", None),
        ("profile = 0x10000\n", AXIS, None),
        ("", AXIS, None),
    ] {
        let rest = [axes, TYPE].concat();
        assert_eq!(default(profile, &rest, "0x1000:00"), expected.map(Value::Integer), "{profile}{axes}");
    }
    let stated = [AXIS, TYPE, "default = 0x192\n"].concat();
    assert_eq!(default("profile = 402\n", &stated, "0x1000:00"), Some(Value::Integer(0x192)));
}

#[test]
fn a_name_of_no_length_is_as_long_as_the_name() {
    let name = |rest: &str| entry("", &format!("[objects.0x1008]\n{rest}"), "0x1008:00");
    let own = || Some(Value::Text("Drive 7".to_owned()));
    assert_eq!(name("type = \"STRING\"\n"), (DataType::Text(7), own()));
    assert_eq!(name("type = \"STRING(16)\"\n"), (DataType::Text(16), None));
    assert_eq!(
        name("type = \"STRING(16)\"\ndefault = \"D\"\n"),
        (DataType::Text(16), Some(Value::Text("D".to_owned())))
    );
}

#[test]
fn the_identity_is_that_of_the_device() {
    const ALL: &str = "[objects.0x1018]\n[objects.0x1018.entries]\n1 = {}\n2 = {}\n3 = {}\n4 = {}\n";
    for (address, expected) in [
        ("0x1018:00", Some(4)),
        ("0x1018:01", Some(0x11)),
        ("0x1018:02", Some(0x22)),
        ("0x1018:03", Some(0x33)),
        // each device has a serial number of its own
        ("0x1018:04", None),
    ] {
        assert_eq!(default("", ALL, address), expected.map(Value::Integer), "{address}");
    }
    let serial = ["serial = 5\n", ALL].concat();
    assert_eq!(default("", &serial, "0x1018:04"), Some(Value::Integer(5)));
    let stated = ALL.replace("2 = {}", "2 = { default = 9 }");
    assert_eq!(default("", &stated, "0x1018:02"), Some(Value::Integer(9)), "rules compare it");
    let narrow = ALL.replace("2 = {}", "2 = { type = \"UINT16\" }");
    assert_eq!(default("", &narrow, "0x1018:02"), None, "it is another thing");
}

#[test]
fn a_slot_is_an_axis() {
    const OBJECTS: &str = "[objects.0xF000]\nname = \"Modular device profile\"\nkind = \"record\"\n[objects.0xF000.entries]\n\
        1 = { name = \"Index distance\", type = \"UINT16\" }\n2 = { name = \"Maximum number of modules\", type = \"UINT16\" }\n\
        [objects.0xF050]\nname = \"Detected modules\"\nkind = \"array\"\n[objects.0xF050.entries]\n\"1..=2\" = { type = \"UINT32\" }\n";
    let modular = [AXES, MODULES, OBJECTS].concat();
    for (address, expected) in
        [("0xF000:01", 0x800), ("0xF000:02", 2), ("0xF050:01", 0x10), ("0xF050:02", 0x20)]
    {
        assert_eq!(default("", &modular, address), Some(Value::Integer(expected)), "{address}");
    }
    let whole = [AXES, OBJECTS].concat();
    assert_eq!(default("", &whole, "0xF000:02"), None, "it has no modules");
}
