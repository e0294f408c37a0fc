//! What kinds of things in a file become, on small files written for it.

use devc::import::{Choice, Imported, NoteKind, import};

use super::round_trip::trip;

const DRIVE: &str = include_str!("files/drive.xml");

/// A file with the parts of one device.
fn file(device: &str) -> String {
    format!(
        "<EtherCATInfo><Vendor><Id>#xE0F</Id><Name>Example</Name></Vendor><Descriptions><Devices>\
         <Device Physics=\"YY\"><Type ProductCode=\"#x1\" RevisionNo=\"#x2\">T-1</Type><Name>Tee</Name>\
         <GroupType>G</GroupType>{device}</Device></Devices></Descriptions></EtherCATInfo>"
    )
}

fn imported(xml: impl AsRef<[u8]>) -> Imported {
    import(xml.as_ref(), "file.xml", &Choice::default()).expect("an import")
}

fn description(xml: impl AsRef<[u8]>) -> String {
    imported(xml).files.into_values().collect()
}

fn notes(xml: impl AsRef<[u8]>, kind: NoteKind) -> Vec<String> {
    let notes = imported(xml).report.notes.into_iter().filter(|note| note.kind == kind);
    notes.map(|note| note.what).collect()
}

#[test]
fn a_drive_means_the_same_after_the_round_trip() {
    let trip = trip(DRIVE.as_bytes(), 1).expect("a round trip");
    assert!(trip.facts > 200, "{}", trip.facts);
    assert_eq!(trip.changed, []);
    assert_eq!(trip.imported.report.lost(), 0, "{:?}", trip.imported.report.notes);
}

#[test]
fn only_the_difference_from_a_profile_is_written() {
    let text = description(DRIVE);
    assert!(text.contains("0x6040 = {}"), "{text}");
    assert!(text.contains(r#"0x6041 = { pdo = "rx-tx" }"#), "{text}");
    assert!(text.contains(r#"0x6064 = { name = "Position" }"#), "{text}");
    assert!(text.contains("0x607A = { min = -1000, max = 1000 }"), "{text}");
    assert!(text.contains(r#"0x6060 = { type = "UINT8", pdo = "none", default = 8 }"#), "{text}");
}

#[test]
fn arrays_and_ranges_are_written_once() {
    let text = description(DRIVE);
    let said_once = "type    = \"INT32\"\naccess  = \"rw\"\npdo     = \"rx\"\ndefault = -1\nmin     = -100\nmax     = 100\n";
    assert!(text.contains(said_once), "{text}");
    assert!(text.contains("\"1..=2\" = {}\n3       = { default = 5 }\n"), "{text}");
    assert!(text.contains(r#""1..=2" = { name = "Gain {}""#), "{text}");
}

#[test]
fn a_file_may_be_in_another_encoding() {
    let drive = file("").replace("Tee", "Überwachung");
    let declared = format!("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>{drive}");
    let latin: Vec<u8> =
        declared.chars().map(|char| u8::try_from(char).expect("a letter of ISO-8859-1")).collect();
    assert_eq!(description(latin), description(&drive));
    assert!(description(&drive).contains("\"Überwachung\""));
    let mut marked = b"\xEF\xBB\xBF".to_vec();
    marked.extend(drive.as_bytes());
    assert_eq!(description(marked), description(drive));
}

#[test]
fn a_file_may_be_in_utf_16() {
    let drive = file("").replace("Tee", "Überwachung");
    let little: Vec<u8> = drive.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = drive.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let marked = [b"\xFE\xFF".to_vec(), big.clone()].concat();
    for bytes in [little, big, marked] {
        assert_eq!(description(bytes), description(&drive));
    }
}

#[test]
fn numbers_come_in_many_spellings() {
    let sm = |number: &str| {
        file(&format!("<Sm StartAddress=\"{number}\" DefaultSize=\"8\" ControlByte=\"38\">MBoxOut</Sm>"))
    };
    let hex = description(sm("#x1000"));
    assert!(hex.contains("0x1000"), "{hex}");
    for same in ["4096", "0x1000", "#x0x1000", "#X1000", " 4096 ", "04096"] {
        assert_eq!(description(sm(same)), hex, "{same}");
    }
    assert_eq!(notes(sm("0o10000"), NoteKind::Lost), ["Sm/@StartAddress"]);
}

#[test]
fn what_is_said_twice_counts_once() {
    let pdo = "<RxPdo><Index>#x1600</Index><Name>A</Name></RxPdo>";
    assert_eq!(notes(file(&pdo.repeat(2)), NoteKind::Lost), ["RxPdo 0x1600"]);
    let sm = "<Sm StartAddress=\"#x1000\" DefaultSize=\"8\" ControlByte=\"#x26\">MBoxOut</Sm>";
    assert!(description(file(&pdo.repeat(2))).matches("[rx-pdos.0x1600]").count() == 1);
    assert!(!description(file(sm)).contains("control"));
}

#[test]
fn what_nobody_knows_is_a_loss_with_its_place() {
    let xml = file("\n  <VendorSpecific><Colour shade=\"dark\">red</Colour></VendorSpecific>");
    let lost = imported(&xml).report.notes;
    assert_eq!(lost.len(), 1);
    assert_eq!((lost[0].place, lost[0].what.as_str(), lost[0].facts), ((2, 3), "Device/VendorSpecific", 2));
}

#[test]
fn what_the_language_cannot_say_is_left_out_and_told() {
    let xml = file(
        "<Profile><Dictionary><DataTypes><DataType><Name>ARRAY [0..9] OF REAL</Name><BitSize>320</BitSize></DataType>\
         </DataTypes><Objects><Object><Index>#x2000</Index><Name>Values</Name><Type>ARRAY [0..9] OF REAL</Type>\
         <BitSize>320</BitSize></Object></Objects></Dictionary></Profile>",
    );
    assert!(!description(&xml).contains("0x2000"));
    assert_eq!(notes(&xml, NoteKind::Lost), ["0x2000 with a type of another kind"]);
}

#[test]
fn a_device_is_chosen_by_number_name_and_revision() {
    let device = |name: &str, code: u32, revision: u32| {
        format!(
            "<Device Physics=\"Y\"><Type ProductCode=\"{code}\" RevisionNo=\"{revision}\">{name}</Type><Name>{name}</Name></Device>"
        )
    };
    let devices = [device("A1", 1, 1), device("A1", 1, 3), device("B1", 2, 1)].concat();
    let xml = format!(
        "<EtherCATInfo><Vendor><Id>1</Id><Name>V</Name></Vendor><Descriptions><Devices>{devices}</Devices></Descriptions></EtherCATInfo>"
    );
    let take = |device: Option<&str>, revision: Option<u32>| {
        let choice = Choice { device: device.map(str::to_owned), revision };
        import(xml.as_bytes(), "file.xml", &choice)
            .map(|imported| imported.files.into_values().collect::<String>())
    };
    let refusal = take(None, None).expect_err("several devices");
    assert_eq!(refusal.choices.len(), 3);
    assert!(refusal.choices[1].contains("revision 0x00000003"), "{:?}", refusal.choices);
    let revision =
        |text: &str| text.lines().find(|line| line.starts_with("revision")).expect("a revision").to_owned();
    assert!(revision(&take(Some("a1"), None).expect("the newest")).ends_with("0x00000003"));
    assert!(revision(&take(Some("A1"), Some(1)).expect("the older")).ends_with("0x00000001"));
    assert!(take(Some("3"), None).expect("by number").contains("B1"));
    assert!(take(Some("C1"), None).is_err());
}

#[test]
fn what_is_no_esi_file_is_refused_with_the_reason() {
    let why =
        |text: &str| import(text.as_bytes(), "file.xml", &Choice::default()).expect_err("no import").why;
    assert!(why("<html/>").contains("`html`"));
    assert!(why("<EtherCATModule/>").contains("modules only"));
    assert!(why("<EtherCATInfo>").contains("ends before"));
    assert!(why("").contains("ends before"));
    assert!(why("<EtherCATInfo/>").contains("no device"));
    assert!(why("<EtherCATInfo></EtherCAT>").len() > 10);
}

/// A file with the drive, and with another that differs a little.
fn two_drives() -> String {
    let start = DRIVE.find("<Device ").expect("a device");
    let end = DRIVE.find("</Devices>").expect("their end");
    let other = DRIVE[start..end]
        .replace("#x00004711", "#x00004712")
        .replace("11470000", "12470000")
        .replace("XD-100", "XD-200")
        .replace("<MaxValue>#x3E8</MaxValue>", "<MaxValue>2000</MaxValue>");
    format!("{}{other}{}", &DRIVE[..end], &DRIVE[end..])
}

#[test]
fn devices_that_share_most_are_a_family() {
    let xml = two_drives();
    let imported = imported(&xml);
    let members: String = imported.files.values().map(String::as_str).collect();
    assert!(members.contains("[members.xd-100.identity]\nproduct-code = 0x00004711\n"), "{members}");
    assert!(members.contains("[members.xd-200.objects]\n0x607A = { min = -1000, max = 2000 }"), "{members}");
    assert_eq!(members.matches("0x6040 = {}").count(), 1, "{members}");
    let (made, _) = super::round_trip::compiled(&imported).expect("an ESI file");
    super::round_trip::same_devices(&xml, &made, 2);
}

#[test]
fn axes_are_described_once() {
    let value = |index: u32, way: &str| {
        format!(
            "<Object><Index>#x{index:04X}</Index><Name>Value</Name><Type>UINT</Type><BitSize>16</BitSize>\
             <Flags><Access>rw</Access><PdoMapping>{way}</PdoMapping></Flags></Object>"
        )
    };
    let objects: String = (0..3)
        .flat_map(|axis| [value(0x6040 + axis * 0x800, "R"), value(0x6041 + axis * 0x800, "T")])
        .collect();
    let pdo = |axis: u32, tag: &str, sm: u32, pdo: u32, object: u32| {
        format!(
            "<{tag} Fixed=\"1\" Sm=\"{sm}\"><Index>#x{:X}</Index><Name>P</Name><Entry><Index>#x{:X}</Index>\
             <SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Value</Name></Entry></{tag}>",
            pdo + axis * 0x10,
            object + axis * 0x800
        )
    };
    let rx: String = (0..3).map(|axis| pdo(axis, "RxPdo", 2, 0x1600, 0x6040)).collect();
    let tx: String = (0..3).map(|axis| pdo(axis, "TxPdo", 3, 0x1A00, 0x6041)).collect();
    let managers: String = [("MBoxOut", 0x1000, 0x26), ("MBoxIn", 0x1100, 0x22), ("Outputs", 0x1200, 0x64), ("Inputs", 0x1400, 0x20)]
        .map(|(name, at, control)| {
            let size = if at < 0x1200 { 128 } else { 6 };
            format!("<Sm DefaultSize=\"{size}\" StartAddress=\"#x{at:X}\" ControlByte=\"#x{control:X}\" Enable=\"1\">{name}</Sm>")
        })
        .concat();
    let xml = file(&format!(
        "<Profile><ProfileNo>402</ProfileNo><Dictionary><DataTypes><DataType><Name>UINT</Name><BitSize>16</BitSize>\
         </DataType></DataTypes><Objects>{objects}</Objects></Dictionary></Profile>{managers}{rx}{tx}\
         <Mailbox DataLinkLayer=\"1\"><CoE/></Mailbox>"
    ));
    let text = description(&xml);
    assert!(text.contains("names  = [\"A\", \"B\", \"C\"]"), "{text}");
    assert!(!text.contains("0x6840") && !text.contains("0x1610"), "{text}");
    let trip = trip(xml.as_bytes(), 1).expect("a round trip");
    assert_eq!(trip.changed, []);
}

#[test]
fn what_differs_between_axes_is_said_per_axis() {
    let value = |index: u32, name: &str, max: u32| {
        format!(
            "<Object><Index>#x{index:04X}</Index><Name>{name}</Name><Type>UINT</Type><BitSize>16</BitSize>\
             <Info><MaxData>{max:04X}</MaxData></Info><Flags><Access>rw</Access></Flags></Object>"
        )
    };
    let objects = [
        value(0x6040, "Word", 1),
        value(0x6041, "State", 1),
        value(0x6042, "Alone", 1),
        value(0x6840, "Word", 2),
        value(0x6841, "State 2", 1),
    ]
    .concat();
    let xml = file(&format!(
        "<Profile><Dictionary><DataTypes/><Objects>{objects}</Objects></Dictionary></Profile>"
    ));
    let text = description(&xml);
    assert!(text.contains("per-axis = { B = { max = 512 } }"), "{text}");
    assert!(text.contains("per-axis = { B = { name = \"State 2\" } }"), "{text}");
    assert!(text.contains("range = \"0x6040..=0x6041\""), "{text}");
    assert_eq!(trip(xml.as_bytes(), 1).expect("a round trip").changed, []);
}
