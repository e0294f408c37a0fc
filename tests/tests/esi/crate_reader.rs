//! The crate `ethercat-esi` reads the file.

use devc::model::{Device, Direction, Pdo};
use ethercat_esi::EtherCatInfo;

use crate::subjects::{Subject, is_named, subjects};

/// What stands for "not assigned" below.
const UNASSIGNED: u8 = 255;

/// The file as the crate can take it: it wants an `Sm` on every PDO, although the schema and all tools take one
/// without it as not assigned, and knows no `Su` and one language only.
fn readable(xml: &str) -> String {
    let with_sm = |line: &str| {
        let pdo = line.trim_start().starts_with("<RxPdo") || line.trim_start().starts_with("<TxPdo");
        match line.strip_suffix('>') {
            Some(open) if pdo && !open.contains(" Sm=") => format!("{open} Sm=\"{UNASSIGNED}\">\n"),
            _ => format!("{line}\n"),
        }
    };
    let is_other = |line: &str| line.contains("LcId=") && !line.contains("LcId=\"1033\"");
    let known = xml.lines().filter(|line| !line.trim_start().starts_with("<Su>") && !is_other(line));
    known.map(with_sm).collect()
}

fn read(subject: &Subject) -> EtherCatInfo {
    EtherCatInfo::from_xml_str(&readable(&subject.xml)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn it_finds_the_identity_of_the_model() {
    for subject in subjects() {
        let info = read(subject);
        assert_eq!(info.vendor.id, subject.family.members[0].identity.vendor_id);
        assert_eq!(info.vendor.name.as_deref(), Some(subject.family.members[0].vendor.as_str()));
        assert_eq!(info.description.devices.len(), subject.family.members.len());
        for (model, device) in subject.family.members.iter().zip(&info.description.devices) {
            assert_eq!(device.desc, model.type_name);
            assert_eq!(device.product_code, model.identity.product_code);
            assert_eq!(device.revision_no, model.identity.revision);
            assert!(info.description.groups.iter().any(|group| group.r#type == model.group));
        }
    }
}

#[test]
fn it_finds_the_sync_managers_of_the_model() {
    for subject in subjects() {
        for (model, device) in subject.family.members.iter().zip(&read(subject).description.devices) {
            let found =
                device.sm.iter().map(|it| (it.start_address, it.control_byte, it.default_size, it.enable));
            let expected = model
                .sync_managers
                .iter()
                .map(|it| (it.address, it.control, Some(it.size.into()), it.enable));
            assert_eq!(found.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
        }
    }
}

#[test]
fn it_finds_the_pdos_of_the_model() {
    for subject in subjects() {
        for (model, device) in subject.family.members.iter().zip(&read(subject).description.devices) {
            let found = device.rx_pdo.iter().chain(&device.tx_pdo);
            let expected = model.pdos_of(Direction::Rx).chain(model.pdos_of(Direction::Tx));
            let (found, expected): (Vec<_>, Vec<_>) = (found.collect(), expected.collect());
            assert_eq!(found.len(), expected.len());
            for expected in expected {
                let found = found.iter().find(|found| u16::from(found.idx) == expected.index.0);
                compare(model, expected, found.unwrap());
            }
        }
    }
}

fn compare(device: &Device, expected: &Pdo, found: &ethercat_esi::Pdo) {
    let manager = device.sync_managers.iter().find(|it| it.pdos.contains(&expected.index));
    assert_eq!(u8::from(found.sm), manager.map_or(UNASSIGNED, |manager| manager.number));
    assert_eq!(u16::from(found.idx), expected.index.0);
    let name = found.name.as_deref().unwrap_or_default();
    assert!(is_named(device, name, &expected.name, expected.axis), "{}: {name}", expected.index);
    assert_eq!((found.fixed, found.mandatory), (expected.fixed, expected.mandatory));
    let entries = found.entries.iter().map(|it| {
        (u16::from(it.entry_idx.idx), u8::from(it.entry_idx.sub_idx), it.bit_len, it.name.is_some())
    });
    let mapped = expected.entries.iter().map(|it| {
        let (index, subindex) = it.address.map_or((0, 0), |address| (address.index.0, address.subindex));
        (index, subindex, it.bits as usize, it.address.is_some())
    });
    assert_eq!(entries.collect::<Vec<_>>(), mapped.collect::<Vec<_>>(), "{}", expected.index);
}
