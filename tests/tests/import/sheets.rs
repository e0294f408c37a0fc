//! Electronic data sheets (CiA 306).

use std::path::Path;

use devc::emit::{self, Options};
use devc::import::{Choice, Imported, NoteKind, import};
use devc::model::{Access, DataType, Device, Entry, Mappable, Object, Value};
use devc::source::{Disk, Memory};

/// A sheet as a tool for CANopen writes it: indices in lower case, an object that says once what holds for all its
/// entries, a value that depends on the node, another that is hexadecimal.
const SHEET: &str = "[FileInfo]
FileName=example.eds
EDSVersion=4.0

[DeviceInfo]
VendorName=Example
VendorNumber=0x00000E0F
ProductName=Motor 7
ProductNumber=3
RevisionNumber=0x00010002
OrderCode=M7
BaudRate_500=1
BaudRate_1000=0
NrOfRXPDO=1

[MandatoryObjects]
SupportedObjects=2
1=0x1000
2=0x1018

[1000]
ParameterName=Device type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x00020192
PDOMapping=0

[1018]
ParameterName=Identity
ObjectType=0x9
SubNumber=2

[1018sub0]
ParameterName=Number of entries
ObjectType=0x7
DataType=0x0005
AccessType=ro
DefaultValue=1

[1018sub1]
ParameterName=Vendor ID
DataType=0x0007
AccessType=ro
DefaultValue=0x00000E0F

[1600] ; what the master sends
ParameterName=Outputs
ObjectType=0x9
SubNumber=3
[1600sub0]
ParameterName=Entries
DataType=0x0005
AccessType=rw
DefaultValue=2
[1600sub1]
ParameterName=First
DataType=0x0007
AccessType=rw
DefaultValue=0x20000010
[1600sub2]
ParameterName=Second
DataType=0x0007
AccessType=rw
DefaultValue=0x20010208

[1c00]
ParameterName=Sync manager types
ObjectType=0x8
CompactSubObj=3
DataType=0x0005
AccessType=ro
[1c00Value]
NrOfEntries=3
1=1
2=2
3=3

[1C12]
ParameterName=Outputs
ObjectType=0x8
CompactSubObj=1
DataType=0x0006
AccessType=rw
DefaultValue=0x1600

[2000]
ParameterName=Speed
ObjectType=0x7
DataType=0x0003
AccessType=rww
LowLimit=-100
HighLimit=100
DefaultValue=-7
PDOMapping=1

[2001]
ParameterName=Gains
ObjectType=0x8
CompactSubObj=3
DataType=0x0005
AccessType=rwr
DefaultValue=4
PDOMapping=1
[2001Name]
NrOfEntries=1
3=Last gain
[2001Value]
NrOfEntries=1
2=0x0A

[2002]
ParameterName=Identifier
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x180

[2003]
ParameterName=Label
DataType=0x0009
AccessType=const
DefaultValue=M7

[2004]
ParameterName=Key
DataType=0x000A
AccessType=wo
DefaultValue=0A1B2C
";

fn imported(text: &str) -> Imported {
    import(text.as_bytes(), "example.eds", &Choice::default()).expect("an import")
}

pub(crate) fn description(imported: &Imported) -> String {
    imported.files.values().map(String::as_str).collect()
}

pub(crate) fn compiled(imported: &Imported) -> Device {
    let files = imported.files.iter();
    let memory =
        files.fold(Memory::new(), |memory, (name, text)| memory.with(format!("drive/{name}"), text.as_str()));
    let compilation = devc::compile(&memory, "drive".as_ref());
    let messages: Vec<&String> = compilation.diagnostics.iter().map(|it| &it.message).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{messages:?}\n{}", description(imported)));
    family.members[0].clone()
}

#[test]
fn a_sheet_becomes_a_description() {
    let imported = imported(SHEET);
    let text = description(&imported);
    let device = compiled(&imported);
    assert_eq!((device.name.as_str(), device.vendor.as_str()), ("Motor 7", "Example"));
    let identity = &device.identity;
    assert_eq!((identity.vendor_id, identity.product_code, identity.revision), (0xE0F, 3, 0x0001_0002));
    assert_eq!((device.type_name.as_str(), device.profile), ("M7", Some(402)));
    let entry = |index: u16, subindex| {
        let object = device.object(index.into()).unwrap_or_else(|| panic!("{index:04X}\n{text}"));
        object.entry(subindex).unwrap_or_else(|| panic!("{index:04X}:{subindex}\n{text}"))
    };
    let speed = entry(0x2000, 0);
    assert_eq!((speed.data_type, speed.access, speed.pdo), (DataType::Int(16), Access::Rw, Mappable::Rx));
    let values = [&speed.min, &speed.max, &speed.default].map(|it| it.as_ref().and_then(Value::integer));
    assert_eq!(values, [Some(-100), Some(100), Some(-7)]);
    let gains: Vec<_> = (1..=3).map(|sub| entry(0x2001, sub)).collect();
    assert!(gains.iter().all(|it| it.data_type == DataType::Uint(8) && it.pdo == Mappable::Tx), "{text}");
    let defaults: Vec<_> = gains.iter().map(|it| it.default.as_ref().and_then(Value::integer)).collect();
    assert_eq!(defaults, [Some(4), Some(10), Some(4)]);
    assert_eq!(gains[2].name, "Last gain");
    assert_eq!(entry(0x2002, 0).default, None);
    assert_eq!((entry(0x2003, 0).data_type, entry(0x2003, 0).access), (DataType::Text(2), Access::Const));
    let key = entry(0x2004, 0);
    assert_eq!((key.data_type, key.access), (DataType::Octets(3), Access::Wo));
    let bytes = key.default.as_ref().map(|it| it.little_endian(key.data_type));
    assert_eq!(bytes, Some(vec![0x0A, 0x1B, 0x2C]));
}

/// 0x20000010 maps 16 bits of 0x2000, and 0x20010208 8 bits of 0x2001:02; 0x1C12 assigns 0x1600 to sync manager 2.
#[test]
fn process_data_follow_from_the_values_of_the_dictionary() {
    let device = compiled(&imported(SHEET));
    let [pdo] = device.pdos.as_slice() else { panic!("{:?}", device.pdos) };
    let mapped = pdo.entries.iter().map(|it| (it.address.map(|it| it.to_string()), it.bits));
    let expected = [(Some("0x2000:00".to_owned()), 16), (Some("0x2001:02".to_owned()), 8)];
    assert_eq!(mapped.collect::<Vec<_>>(), expected);
    assert!(!pdo.fixed);
    let roles: Vec<_> = device.sync_managers.iter().map(|it| it.id.as_str()).collect();
    assert_eq!(roles, ["mailbox-out", "mailbox-in", "outputs"]);
    assert_eq!(device.sync_managers[2].pdos, [pdo.index]);
    let mailbox = device.mailbox.expect("a mailbox");
    assert!(mailbox.pdo_assign && mailbox.pdo_config && !mailbox.sdo_info);
}

#[test]
fn what_a_sheet_says_of_can_is_lost_and_told() {
    let imported = imported(SHEET);
    let lost = imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    let lost: Vec<_> = lost.map(|note| (note.what.as_str(), note.place.0)).collect();
    let line = |text: &str| SHEET.lines().position(|line| line.starts_with(text)).expect("a line") + 1;
    assert_eq!(
        lost,
        [
            ("[DeviceInfo] BaudRate_500", line("BaudRate_500")),
            ("the default of 0x2002", line("DefaultValue=$NODEID")),
        ]
    );
    // Where the areas of the sync managers lie is in no sheet.
    let guessed = imported.report.notes.iter().filter(|note| note.kind == NoteKind::Guessed);
    assert!(guessed.filter(|note| note.what.starts_with("the address of")).count() == 3);
}

#[test]
fn what_is_no_sheet_is_refused_with_its_place() {
    let refusal = import(b"[DeviceInfo]\nVendorName=A\nnonsense\n", "a.eds", &Choice::default());
    let refusal = refusal.expect_err("no sheet");
    assert_eq!(refusal.place, Some((3, 1)));
}

/// What a sheet tells of an entry: BYTE, WORD, DWORD and bits are the numbers of their width there.
fn told(device: &Device, object: &Object, entry: &Entry) -> String {
    let kind = match entry.data_type {
        DataType::Bits(1) => DataType::Bool,
        DataType::Bits(_) => DataType::Uint(8),
        DataType::Bitstring(bits) => DataType::Uint(bits),
        // Its length is that of its default, if it has one.
        DataType::Text(_) if entry.default.is_none() => DataType::Text(1),
        DataType::Text(_) => {
            DataType::Text(entry.default.as_ref().map_or(1, |it| it.to_string().len().max(1) as u16))
        }
        other => other,
    };
    // A limit that the type has anyway says nothing.
    let is_bound = |value: &&Value| {
        let bounds = kind.range().map(|(min, max)| [min, max]).unwrap_or_default();
        value.integer().is_some_and(|value| bounds.contains(&value))
    };
    let bytes = |value: &Option<Value>| value.as_ref().map(|value| value.little_endian(kind));
    let limit =
        |value: &Option<Value>| value.as_ref().filter(|it| !is_bound(it)).map(|it| it.little_endian(kind));
    let mapped = match (entry.access, entry.pdo) {
        (_, Mappable::None) => Mappable::None,
        (Access::Ro | Access::Const, _) => Mappable::Tx,
        (Access::Wo, _) => Mappable::Rx,
        (Access::Rw, mapped) => mapped,
    };
    let name = if object.entries.len() == 1 { "" } else { entry.name.as_str() };
    let (values, access) = ([bytes(&entry.default), limit(&entry.min), limit(&entry.max)], entry.access);
    let object_name = device.on_axis(&object.name, object.axis);
    format!("{} {object_name:?} {name:?} {kind} {access:?} {mapped:?} {values:?}", entry.address)
}

#[test]
fn a_dictionary_is_the_same_after_a_sheet_was_made_of_it() {
    let devices = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    let mut seen = 0;
    for folder in ["s700"] {
        let family = devc::compile(&Disk, &devices.join(folder)).family.expect("a description");
        let sheets = emit::emit(&family, &[&emit::eds::Eds], &Options::default());
        for device in &family.members {
            let name = format!("{}.eds", device.id);
            let sheet = &sheets.0[&name];
            let imported = import(sheet, &name, &Choice::default()).expect("an import");
            let lost: Vec<_> = imported.report.notes.iter().filter(|it| it.kind == NoteKind::Lost).collect();
            assert!(lost.is_empty(), "{lost:?}");
            let again = compiled(&imported);
            for object in &device.objects {
                let other = again.object(object.index).unwrap_or_else(|| panic!("{} is gone", object.index));
                let dictionary = |device: &Device, object: &Object| -> Vec<String> {
                    object.entries.iter().map(|entry| told(device, object, entry)).collect()
                };
                assert_eq!(dictionary(device, object), dictionary(&again, other), "{name}");
                assert_eq!(object.kind, other.kind, "{name} {}", object.index);
                seen += object.entries.len();
            }
            assert_eq!(device.objects.len(), again.objects.len());
        }
    }
    assert!(seen > 300, "{seen}");
}
