//! Electronic data sheets that devc made of shipped devices: what is read from them is what they were made of.

use std::path::Path;

use devc::emit::{self, Options};
use devc::import::{Choice, import};
use devc::model::{DataType, Device, Entry};
use devc::source::Disk;

use super::sheets::compiled;

/// What a sheet says of process data: the entries of each PDO and their widths.
fn mapping(device: &Device) -> Vec<String> {
    let mapped = device.pdos.iter().map(|pdo| {
        let entries = pdo.entries.iter().map(|it| format!("{:?}/{}", it.address, it.bits));
        format!("{} {:?}", pdo.index, entries.collect::<Vec<_>>())
    });
    let mut mapped: Vec<String> = mapped.collect();
    mapped.sort();
    mapped
}

/// The entries of the dictionary, each with its width, access, default and limits. CiA 306 has no length of texts, no words,
/// and no direction of what can be mapped.
fn dictionary(device: &Device) -> Vec<String> {
    let entries = device.objects.iter().flat_map(|object| &object.entries);
    let told = |it: &Entry| {
        let bits = (!matches!(it.data_type, DataType::Text(_))).then(|| it.data_type.bits());
        format!("{} {bits:?} {:?} {:?}", it.address, it.access, [&it.default, &it.min, &it.max])
    };
    entries.map(told).collect()
}

#[test]
fn all_axes_are_read_again() {
    let devices = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    let mut seen = 0;
    for folder in ["c887", "pmc-sc6", "s700"] {
        let family = devc::compile(&Disk, &devices.join(folder)).family.expect("a description");
        let sheets = emit::emit(&family, &[&emit::eds::Eds], &Options::default());
        for device in &family.members {
            let name = format!("{}.eds", device.id);
            let imported = import(&sheets.0[&name], &name, &Choice::default());
            let again = compiled(&imported.unwrap_or_else(|refusal| panic!("{name}: {refusal:?}")));
            assert_eq!(mapping(device), mapping(&again), "{name}");
            let (before, after) = (dictionary(device), dictionary(&again));
            let lost: Vec<_> = before.iter().zip(&after).filter(|(before, after)| before != after).collect();
            assert!(lost.is_empty() && before.len() == after.len(), "{name}: {lost:#?}");
            seen += 1;
        }
    }
    assert_eq!(seen, 9);
}
