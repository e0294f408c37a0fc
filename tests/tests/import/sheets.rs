//! Electronic data sheets (CiA 306).

use devc::import::{Choice, Imported, NoteKind, import};
use devc::model::{Access, DataType, Device, Mappable, Value};

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
    let compilation = devc::compile(&imported.in_memory("drive"), "drive".as_ref());
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
            ("the name of subindex 0", line("[1018]")),
            ("names in a mapping object", line("[1600]")),
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

/// A semicolon within a word is part of it; what a configured sheet (DCF) adds, and what depends on a node, are no facts
/// of the device, and the report says so.
#[test]
fn what_is_of_a_node_and_not_of_the_device_is_said() {
    let sheet =
        SHEET.replace("ParameterName=Identity", "ParameterName=Identity;set ; of all\nParameterValue=3");
    let imported = import(sheet.as_bytes(), "drive.eds", &Choice::default()).expect("a description");
    let toml: String = imported.files.values().map(String::as_str).collect();
    assert!(toml.contains("name = \"Identity;set\""), "{toml}");
    let whys: Vec<&str> = imported.report.notes.iter().map(|note| note.why.as_str()).collect();
    assert!(whys.contains(&"it is what one node was set up with"), "{whys:?}");
    assert!(
        whys.iter().any(|why| why.ends_with("it depends on the number of a node of CANopen")),
        "{whys:?}"
    );
}
