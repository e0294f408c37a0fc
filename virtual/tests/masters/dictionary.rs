//! The dictionary as a master reads it, against the ESI file of the device, which another reader reads.

use std::path::Path;

use devc::model::Device;
use devc_tests::esi_reader;

use crate::bus::{Bytes, found, run};
use crate::shared::devices;

/// The device in the ESI file of its family.
fn in_file(device: &Device) -> esi_reader::Device {
    let family = ["c887", "s700", "pmc-sc6"].into_iter().find_map(|family| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../generated/{family}/{family}.xml"));
        let text = std::fs::read_to_string(path).expect("the output is there");
        let devices = esi_reader::read(&text).expect("it is an ESI file").devices;
        devices.into_iter().find(|other| other.type_name == device.type_name)
    });
    family.expect("it is in a file")
}

/// What changes by itself: actual values, which the drive shows as soon as it is on.
fn is_actual(value: &esi_reader::Value) -> bool {
    let mapped = value.flags.pdo_mapping.as_deref().unwrap_or_default();
    value.flags.access == "ro" && mapped.contains('T') || value.index == 0x1001
}

#[test]
fn every_entry_has_the_default_of_the_esi_file() {
    for device in devices() {
        let described = in_file(device);
        let compared = run(
            device,
            |_| (),
            async |master| {
                let group = found(master).await;
                let drive = group.subdevice(master, 0).expect("the first");
                let mut compared = 0;
                for object in &described.dictionary.objects {
                    let values = described.dictionary.values(object).expect("the types are declared");
                    for value in values.iter().filter(|value| value.flags.access != "wo" && !is_actual(value))
                    {
                        let read = drive.sdo_read::<Bytes>(value.index, value.subindex).await;
                        let Bytes(read) =
                            read.unwrap_or_else(|error| panic!("{:04X}: {error:?}", value.index));
                        let mut expected = value.info.default.clone().unwrap_or_default();
                        let length = if value.basic_type.starts_with("STRING") {
                            read.len()
                        } else {
                            value.bits.div_ceil(8) as usize
                        };
                        expected.resize(length, 0);
                        assert_eq!(
                            read, expected,
                            "0x{:04X}:{:02X} of {}",
                            value.index, value.subindex, device.name
                        );
                        compared += 1;
                    }
                }
                compared
            },
        );
        assert!(compared > 150, "{compared} of {}", device.name);
    }
}
