//! What an image says is what the ESI of the device says: both describe the same hardware, and the ESI is held against the
//! model and the manuals by tests of its own.

use std::path::Path;

use devc::model::Family;
use devc::source::Disk;
use devc_tests::esi_reader::{self, Device, Esi, PdoEntry};

use crate::reader::{Image, Pdo};

/// What stands in for the bytes that no manual gives: an interface of 8 bits, and where SYNC0 goes.
pub(crate) const CONFIG_DATA: [u8; 6] = [0x09, 0x00, 0x00, 0x08, 0x00, 0x00];

/// The families that are shipped.
pub(crate) const SHIPPED: [&str; 3] = ["c887", "pmc-sc6", "s700"];

pub(crate) fn family(id: &str) -> devc::lint::Checked<Family> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(id);
    devc::compile(&Disk, &folder).family.unwrap()
}

fn esi(id: &str) -> Esi {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../generated/{id}/{id}.xml"));
    esi_reader::read(&std::fs::read_to_string(file).unwrap()).unwrap()
}

#[test]
fn all_devices_have_in_the_eeprom_what_is_in_the_esi() {
    let mut devices = 0;
    for id in SHIPPED {
        let (family, esi) = (family(id), esi(id));
        for (device, told) in family.members.iter().zip(&esi.devices) {
            let image = Image::read(&devc::sii::image(device, &CONFIG_DATA).unwrap());
            header(&image, esi.vendor_id, told);
            general(&image, told);
            areas(&image, told);
            pdos(&image.pdos(51), &told.rx_pdos);
            pdos(&image.pdos(50), &told.tx_pdos);
            clocks(&image, told);
            devices += 1;
        }
    }
    assert_eq!(devices, 9);
}

fn header(image: &Image, vendor_id: u32, told: &Device) {
    let config: Vec<u8> = image.words[..3].iter().flat_map(|word| word.to_le_bytes()).collect();
    assert_eq!(config, CONFIG_DATA);
    assert_eq!(image.words[3..7], [0; 4], "alias and reserved words");
    assert_eq!(image.long(0x08), vendor_id);
    assert_eq!((image.long(0x0A), image.long(0x0C)), (told.product_code, told.revision));
    let areas: Vec<u16> = told.sync_managers[..2].iter().flat_map(|it| [it.address, it.size]).collect();
    assert_eq!(image.words[0x14..0x18], [0; 4], "no mailbox for bootstrap is known");
    assert_eq!(image.words[0x18..0x1C], areas, "the mailbox that the drive receives by, then the other");
    let bit = |protocol: &str| match protocol {
        "EoE" => 2,
        "CoE" => 4,
        "FoE" => 8,
        other => panic!("{other}"),
    };
    assert_eq!(image.words[0x1C], told.protocols.iter().map(|it| bit(it)).sum::<u16>());
    assert!(image.words[0x1D..0x3E].iter().all(|word| *word == 0), "reserved words");
}

fn general(image: &Image, told: &Device) {
    let data = image.category(30).unwrap();
    assert_eq!(data.len(), 32);
    assert_eq!(image.string(data[0]), told.group);
    assert_eq!(image.string(data[2]), told.type_name);
    assert!(told.name.starts_with(image.string(data[3])), "{} {}", image.string(data[3]), told.name);
    let coe = told.coe.as_ref().unwrap();
    let abilities = [true, coe.sdo_info, coe.pdo_assign, coe.pdo_config, false, coe.complete_access];
    assert_eq!(data[5], (0..6).map(|bit| u8::from(abilities[bit]) << bit).sum::<u8>());
    let speaks = |protocol: &str| u8::from(told.protocols.iter().any(|it| it == protocol));
    assert_eq!(data[6..9], [speaks("FoE"), speaks("EoE"), 0]);
    assert_eq!(usize::from(data[9]), told.channels.len(), "DS402 channels");
    assert_eq!(data[10..16], [0, 4, 0, 0, data[0], 0], "mail is acknowledged, no current, the group again");
    assert_eq!(
        (told.physics.as_str(), &data[16..18]),
        ("YY", [0x11, 0].as_slice()),
        "two ports of 100BASE-TX"
    );
}

fn areas(image: &Image, told: &Device) {
    let kinds = ["MBoxOut", "MBoxIn", "Outputs", "Inputs"];
    let rows = image.category(41).unwrap().chunks(8);
    assert_eq!(rows.len(), told.sync_managers.len());
    for (row, told) in rows.zip(&told.sync_managers) {
        let [[a, b], [c, d]] = [told.address, told.size].map(u16::to_le_bytes);
        let kind = u8::try_from(kinds.iter().position(|kind| *kind == told.kind).unwrap() + 1).unwrap();
        assert_eq!(row, [a, b, c, d, told.control, 0, u8::from(told.enabled), kind]);
    }
    let units = told.fmmus.iter().map(|unit| match unit.kind.as_str() {
        "Outputs" => 1,
        "Inputs" => 2,
        "MBoxState" => 3,
        other => panic!("{other}"),
    });
    let mut units: Vec<u8> = units.collect();
    units.resize(units.len().next_multiple_of(2), 0xFF);
    assert_eq!(image.category(40).unwrap(), units);
}

/// The PDOs are in the order of the file, all or those that have a sync manager.
fn pdos(found: &[Pdo], told: &[esi_reader::Pdo]) {
    let all = found.len() == told.len();
    let told = told.iter().filter(|pdo| all || pdo.sync_manager.is_some());
    let mut count = 0;
    for (found, told) in found.iter().zip(told) {
        assert_eq!((found.index, &found.name), (told.index, &told.name));
        assert_eq!(usize::from(found.sync_manager), told.sync_manager.unwrap_or(0xFF));
        let flags = [(told.mandatory, 1), (told.sync_manager.is_some(), 2), (told.fixed, 0x10)];
        assert_eq!(found.flags, flags.iter().filter(|(set, _)| *set).map(|(_, flag)| flag).sum::<u16>());
        assert_eq!(found.entries.len(), told.entries.len());
        for (found, told) in found.entries.iter().zip(&told.entries) {
            assert_eq!((found.index, found.subindex), (told.index, told.subindex.unwrap_or(0)));
            assert_eq!((u32::from(found.bits), found.data_type), (told.bits, code(told)), "{told:?}");
            assert!(told.name.as_deref().unwrap_or_default().starts_with(&found.name), "{told:?}");
        }
        count += 1;
    }
    assert_eq!(count, found.len());
    assert!(count > 0);
}

/// The numbers of types, ETG.1020, base data types.
fn code(told: &PdoEntry) -> u8 {
    match told.data_type.as_deref() {
        None => 0,
        Some("SINT") => 0x02,
        Some("INT") => 0x03,
        Some("DINT") => 0x04,
        Some("UINT") => 0x06,
        Some("WORD") => 0x1F,
        Some("DWORD") => 0x20,
        Some(other) => panic!("{other}"),
    }
}

fn clocks(image: &Image, told: &Device) {
    let rows = image.category(60).unwrap().chunks(24);
    assert_eq!(rows.len(), told.op_modes.len());
    for (row, told) in rows.zip(&told.op_modes) {
        let factor = told.sync0.as_ref().map_or(0, |signal| signal.factor.unwrap_or(0));
        let shift = told.sync0.as_ref().map_or(0, |signal| signal.shift);
        assert!(told.sync1.is_none(), "no device that is shipped has a second signal");
        assert_eq!(row[..4], [0; 4], "the master chooses the period");
        assert_eq!(row[4..8], shift.to_le_bytes());
        assert_eq!(row[8..14], [0; 6], "nothing of a second signal");
        assert_eq!(row[14..16], told.assign_activate.to_le_bytes());
        assert_eq!(row[16..18], i16::try_from(factor).unwrap().to_le_bytes());
        assert_eq!(image.string(row[18]), told.name);
        assert_eq!(Some(image.string(row[19])), told.description.as_deref());
        assert_eq!(row[20..], [0; 4]);
    }
}
