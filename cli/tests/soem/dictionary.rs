//! The dictionaries of all nine devices as SOEM reads them, against the ESI files, which another reader reads.

use devc_tests::esi_reader::{self, Device, Value};
use serde_json::{Value as Json, json};

use super::{NINE, network, workspace};

/// SOEM keeps so many characters of a name.
const NAME: usize = 40;

/// The devices in the order of the cable.
pub(crate) fn described() -> Vec<Device> {
    let families = ["c887", "s700", "pmc-sc6"].map(|family| {
        let path = workspace().join(format!("generated/{family}/{family}.xml"));
        esi_reader::read(&std::fs::read_to_string(path).expect("the output is there"))
            .expect("it is an ESI file")
    });
    families.into_iter().flat_map(|file| file.devices).collect()
}

/// The entries of a device that a master may read.
fn entries(device: &Device) -> Vec<Value> {
    let objects = device.dictionary.objects.iter();
    let values = objects.flat_map(|object| device.dictionary.values(object).expect("the types are declared"));
    values.filter(|value| value.flags.access != "wo").collect()
}

/// What changes by itself: actual values, which the drive shows as soon as it is on.
fn is_actual(value: &Value) -> bool {
    let mapped = value.flags.pdo_mapping.as_deref().unwrap_or_default();
    value.flags.access == "ro" && mapped.contains('T') || value.index == 0x1001
}

/// What the file says, in hexadecimal as it travels; a text without what fills it up.
fn default(value: &Value) -> String {
    let mut bytes = value.info.default.clone().unwrap_or_default();
    bytes.resize(value.bits.div_ceil(8) as usize, 0);
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn is_same(value: &Value, read: &str) -> bool {
    match value.basic_type.starts_with("STRING") {
        true => read.trim_end_matches("00") == default(value).trim_end_matches("00"),
        false => read == default(value),
    }
}

#[test]
fn every_entry_has_the_default_of_the_esi_file() {
    let Some(mut network) = network("dictionary") else { return };
    network.run(&NINE);
    let devices = described();
    let tells = |device: &Device| device.coe.as_ref().is_some_and(|coe| coe.sdo_info);
    let asked = devices.iter().map(|device| {
        let addresses =
            entries(device).iter().map(|value| json!([value.index, value.subindex])).collect::<Vec<_>>();
        json!([addresses, tells(device)])
    });
    let told = network.ask("dictionary.py", &asked.collect());
    assert_eq!(told.len(), 9);
    let mut names = 0;
    for (device, told) in devices.iter().zip(&told) {
        let (entries, read) = (entries(device), told["values"].as_array().expect("a list"));
        assert!(entries.len() > 150 && entries.len() == read.len(), "{}: {}", device.name, read.len());
        for (value, read) in entries.iter().zip(read) {
            let read = read.as_str().expect("a text");
            let is_right = if is_actual(value) { !read.starts_with("0x") } else { is_same(value, read) };
            assert!(is_right, "0x{:04X}:{:02X} of {}: {read}", value.index, value.subindex, device.name);
        }
        if tells(device) {
            objects(device, told["objects"].as_array().expect("a list"));
            names += 1;
        }
    }
    // the C-887, and the Pilz drives of the template with SDO information
    assert_eq!(names, 3);
}

/// A name as the device has it: the file says of which axis it is, so that names differ.
fn without_axis(name: &str) -> &str {
    let axes = ["A", "B", "X", "Y", "Z", "U", "V", "W"];
    let named = axes.into_iter().find_map(|axis| name.strip_suffix(&format!(" ({axis})")));
    named.unwrap_or(name)
}

/// What a device tells of its objects: names, and of each entry its name and width.
fn objects(device: &Device, told: &[Json]) {
    let short = |name: &str| without_axis(name).chars().take(NAME).collect::<String>();
    let expected: Vec<_> = device.dictionary.objects.iter().map(|it| (it.index, short(&it.name))).collect();
    let indices = told.iter().map(|object| {
        let index = object[0].as_u64().expect("a number") as u16;
        (index, short(object[1].as_str().expect("a text")))
    });
    assert_eq!(indices.collect::<Vec<_>>(), expected, "{}", device.name);
    for (object, told) in device.dictionary.objects.iter().zip(told) {
        let values = device.dictionary.values(object).expect("the types are declared");
        let Some(listed) = told[3].as_array().filter(|listed| !listed.is_empty()) else { continue };
        for value in values {
            let entry = listed.get(usize::from(value.subindex)).expect("it is told");
            let expected = json!([short(&value.name), value.bits]);
            assert_eq!(json!([entry[0], entry[2]]), expected, "0x{:04X}:{:02X}", value.index, value.subindex);
        }
    }
}
