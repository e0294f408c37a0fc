//! What files of makers that nobody has seen yet may spell in a way of their own: each is kept, or in the report.

use devc::import::{Choice, Imported, NoteKind, import};

use super::round_trip::compiled;
use super::transport::{file, value};

fn imported(xml: impl AsRef<[u8]>) -> Imported {
    let imported = import(xml.as_ref(), "drive.xml", &Choice::default()).expect("a description");
    compiled(&imported).expect("an ESI");
    imported
}

fn text(imported: &Imported) -> String {
    imported.files.values().map(String::as_str).collect()
}

/// What is reported, but for what tools save.
fn notes(imported: &Imported, kind: NoteKind) -> Vec<(&str, usize)> {
    let notes = imported.report.notes.iter().filter(|note| note.kind == kind);
    notes
        .map(|note| (note.what.as_str(), note.facts))
        .filter(|(what, _)| !["what tools save", "what can be mapped"].contains(what))
        .collect()
}

/// A record with two members of 16 bits, with what the object says of them.
fn record(members: &str, infos: &str) -> String {
    let kind = format!(
        "<DataType><Name>DT2000</Name><BitSize>48</BitSize><SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name>\
         <Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>{members}</DataType>"
    );
    let object = format!(
        "<Object><Index>#x2000</Index><Name>R</Name><Type>DT2000</Type><BitSize>48</BitSize><Info>{infos}</Info></Object>"
    );
    file("", &object, "").replacen("<DataTypes>", &format!("<DataTypes>{kind}"), 1)
}

fn member(subindex: &str, name: &str) -> String {
    format!(
        "<SubItem><SubIdx>{subindex}</SubIdx><Name>{name}</Name><Type>UINT</Type><BitSize>16</BitSize>\
         <BitOffs>16</BitOffs></SubItem>"
    )
}

/// A code page of DOS has an umlaut where Windows-1252 has a quotation mark.
#[test]
fn bytes_that_are_not_what_a_file_says_are_told() {
    let file = |declaration: &str| {
        let xml = file("", &value("#x2000", "UINT", 16, ""), "");
        let (head, tail) = xml.split_once("Value").expect("a name");
        [declaration.as_bytes(), head.as_bytes(), b"V\x94lue", tail.as_bytes()].concat()
    };
    for said in ["", "<?xml version=\"1.0\"?>", "<?xml version=\"1.0\" encoding=\"utf-8\"?>"] {
        assert_eq!(notes(&imported(file(said)), NoteKind::Guessed), [("the encoding", 0)], "{said}");
    }
    let declared = imported(file("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>"));
    assert_eq!(notes(&declared, NoteKind::Guessed), []);
}

/// Numbers of languages, [MS-LCID]: 1031 is German, 2057 English as in Britain.
#[test]
fn a_name_that_is_not_english_is_told_where_it_is_taken_for_it() {
    let lost = |lcid: &str| {
        let object = value("#x2000", "UINT", 16, "").replace("<Name>", &format!("<Name LcId=\"{lcid}\">"));
        let imported = imported(file("", &object, ""));
        assert!(text(&imported).contains("Value #x2000"));
        notes(&imported, NoteKind::Lost).len()
    };
    assert_eq!(["1033", "2057", "0", "1", "1031", "2052"].map(lost), [0, 0, 0, 0, 1, 1]);
}

#[test]
fn values_go_by_the_subindex_that_their_names_are() {
    let info = |name: &str, data: &str| {
        format!("<SubItem><Name>{name}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>")
    };
    let members = member("1", "Gain") + &member("17", "Gain");
    let said = |infos: &str| text(&imported(record(&members, infos)));
    let by_number = said(&(info("SubIndex 017", "1100") + &info("SubIndex 001", "0100")));
    assert!(by_number.contains("1 = { name = \"Gain\", default = 1 }"), "{by_number}");
    assert!(by_number.contains("17 = { name = \"Gain\", default = 17 }"), "{by_number}");
    // Other names say nothing, and the order counts: the first is that of subindex 0.
    let in_order = said(&(info("a", "11") + &info("b", "0200")));
    assert!(in_order.contains("1 = { name = \"Gain\", default = 2 }"), "{in_order}");
}

#[test]
fn a_subindex_that_is_none_leads_nowhere() {
    for other in ["300", "x", "-1"] {
        let imported = imported(record(&(member("1", "Gain") + &member(other, "Over")), ""));
        assert!(!text(&imported).contains("Over"), "{}", text(&imported));
        let lost = notes(&imported, NoteKind::Lost);
        assert_eq!(lost.iter().map(|(_, facts)| facts).sum::<usize>(), 5, "{lost:?}");
    }
}

#[test]
fn what_is_no_direction_is_none() {
    let said = |word: &str| {
        let object = value("#x2000", "UINT", 16, &format!("<PdoMapping>{word}</PdoMapping>"));
        let imported = imported(file("", &object, ""));
        (text(&imported).contains("pdo = "), notes(&imported, NoteKind::Lost).len())
    };
    assert_eq!(["R", "rt", "Tx", "RX"].map(said), [(true, 0); 4]);
    assert_eq!(["true", "none", "Receive"].map(said), [(false, 1); 3]);
}

/// Types by their names in CiA 301 and IEC 61131-3.
#[test]
fn types_have_names_in_other_standards() {
    for (name, bits, taken) in [
        ("INTEGER16", 16, "INT16"),
        ("UNSIGNED32", 32, "UINT32"),
        ("Unsigned8", 8, "UINT8"),
        ("STRING[8]", 64, "STRING(8)"),
        ("VISIBLE_STRING[4]", 32, "STRING(4)"),
    ] {
        let imported = imported(file("", &value("#x2000", name, bits, ""), ""));
        assert!(text(&imported).contains(&format!("type = \"{taken}\"")), "{name}: {}", text(&imported));
        assert_eq!(notes(&imported, NoteKind::Guessed), [], "{name}");
    }
}

#[test]
fn modes_without_a_name_get_one() {
    let mode =
        |name: &str| format!("<OpMode><Name>{name}</Name><AssignActivate>#x300</AssignActivate></OpMode>");
    let imported = imported(file("", "", &format!("<Dc>{}{}</Dc>", mode("DC"), mode(""))));
    assert_eq!(notes(&imported, NoteKind::Guessed), [("the name of an OpMode", 0)]);
    assert!(text(&imported).contains("[sync-modes.\"Mode 2\"]"), "{}", text(&imported));
}

#[test]
fn padding_has_neither_type_nor_subindex() {
    let pdo = |inside: &str| {
        let pdo = format!(
            "<TxPdo Fixed=\"1\"><Index>#x1A00</Index><Name>P</Name><Entry><Index>0</Index>{inside}</Entry></TxPdo>"
        );
        notes(&imported(file("", "", &pdo)), NoteKind::Lost).iter().map(|(_, facts)| facts).sum::<usize>()
    };
    assert_eq!(pdo("<BitLen>8</BitLen>"), 0);
    assert_eq!(pdo("<SubIndex>0</SubIndex><BitLen>8</BitLen>"), 0);
    assert_eq!(pdo("<SubIndex>5</SubIndex><BitLen>8</BitLen><DataType>USINT</DataType>"), 2);
}

#[test]
fn names_of_slots_that_are_no_axes_are_told() {
    let slot = |name: &str| {
        format!(
            "<Slot MinInstances=\"1\" MaxInstances=\"1\">{name}<ModuleIdent Default=\"1\">#x10</ModuleIdent></Slot>"
        )
    };
    let lost = |name: &str| {
        let slots =
            format!("<Slots SlotPdoIncrement=\"16\" SlotIndexIncrement=\"#x100\">{}</Slots>", slot(name));
        let module = "<Modules><Module><Type ModuleIdent=\"#x10\">M</Type><Name>M</Name></Module></Modules>";
        let xml = file("", "", &slots).replace("</Devices>", &format!("</Devices>{module}"));
        notes(&imported(xml), NoteKind::Lost).iter().map(|(_, facts)| facts).sum::<usize>()
    };
    assert_eq!(lost("<Name>Front</Name>"), lost("") + 1);
}

/// `hexBinary` is digits in pairs, without a prefix.
#[test]
fn data_that_are_no_bytes_are_told_as_such() {
    for written in ["0", "0xFF00", "#x0100", "1.5"] {
        let object = value("#x2000", "UINT", 16, "");
        let info = format!("<Info><DefaultData>{written}</DefaultData></Info><Flags>");
        let imported = imported(file("", &object.replace("<Flags>", &info), ""));
        let note = imported.report.notes.iter().find(|note| note.kind == NoteKind::Lost).expect("a loss");
        assert_eq!(
            (note.says.as_str(), note.why.as_str()),
            (written, "it is not bytes in hexadecimal of one value")
        );
    }
}
