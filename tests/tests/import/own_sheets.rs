//! Electronic data sheets that devc made of shipped devices: what is read from them is what they were made of.

use std::path::Path;

use devc::emit::{self, Options};
use devc::import::{Choice, import};
use devc::model::Device;
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

/// The entries of the dictionary, each with its access.
fn dictionary(device: &Device) -> Vec<String> {
    let entries = device.objects.iter().flat_map(|object| &object.entries);
    entries.map(|it| format!("{} {:?}", it.address, it.access)).collect()
}

#[test]
fn all_axes_are_read_again() {
    let devices = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    let mut seen = 0;
    for folder in ["c887", "s700"] {
        let family = devc::compile(&Disk, &devices.join(folder)).family.expect("a description");
        let sheets = emit::emit(&family, &[&emit::eds::Eds], &Options::default());
        for device in &family.members {
            let name = format!("{}.eds", device.id);
            let imported = import(&sheets.0[&name], &name, &Choice::default());
            let again = compiled(&imported.unwrap_or_else(|refusal| panic!("{name}: {refusal:?}")));
            assert_eq!(mapping(device), mapping(&again), "{name}");
            assert_eq!(dictionary(device), dictionary(&again), "{name}");
            seen += 1;
        }
    }
    assert_eq!(seen, 5);
}
