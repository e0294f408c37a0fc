//! What a description says, and the ESI made of it, otherwise than the file, and what the report tells of that.

use devc::import::{Choice, Imported, NoteKind, import};

use super::round_trip::compiled;
use super::transport::{file, value};

fn imported(xml: impl AsRef<[u8]>) -> Imported {
    import(xml.as_ref(), "file.xml", &Choice::default()).expect("an import")
}

/// What and why, of the notes of a kind.
fn notes(imported: &Imported, kind: NoteKind) -> Vec<(&str, &str)> {
    let notes = imported.report.notes.iter().filter(|note| note.kind == kind);
    notes.map(|note| (note.what.as_str(), note.why.as_str())).collect()
}

fn whats(imported: &Imported, kind: NoteKind) -> Vec<&str> {
    notes(imported, kind)
        .into_iter()
        .map(|(what, _)| what)
        .filter(|what| *what != "what tools save")
        .collect()
}

#[test]
fn a_name_in_the_spelling_of_its_profile_is_told() {
    let named = |name: &str| {
        let object = value("#x1009", "ARRAY [0..9] OF BYTE", 80, "").replace("Value #x1009", name);
        imported(file("", &object, ""))
    };
    // The profile calls it so, or in other letters, or otherwise.
    assert_eq!(whats(&named("Manufacturer hardware version"), NoteKind::Lost), Vec::<&str>::new());
    let other = named("Manufacturer Hardware-Version");
    assert_eq!(whats(&other, NoteKind::Lost), ["the spelling of a name"]);
    assert_eq!(other.report.lost(), 0);
    assert!(named("Board").files["device.toml"].contains("\"Board\""));
}

#[test]
fn a_record_of_nothing_but_its_count_is_told() {
    let kind = "<DataType><Name>DTC</Name><BitSize>16</BitSize><SubItem><SubIdx>0</SubIdx><Name>N</Name><Type>USINT</Type>\
        <BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem></DataType>";
    let object =
        "<Object><Index>#x2000</Index><Name>Channel</Name><Type>DTC</Type><BitSize>16</BitSize></Object>";
    let imported = imported(file("", object, "").replacen("<DataTypes>", &format!("<DataTypes>{kind}"), 1));
    assert_eq!(whats(&imported, NoteKind::Lost), ["the record 0x2000"]);
}

#[test]
fn whether_mail_is_acknowledged_is_a_guess_if_the_file_does_not_say_it() {
    let guesses = |said: &str| {
        let imported = imported(file("", "", &format!("<Mailbox{said}><CoE/></Mailbox>")));
        (whats(&imported, NoteKind::Guessed).len(), imported.report.lost())
    };
    assert_eq!(guesses(""), (1, 0));
    assert_eq!(guesses(" DataLinkLayer=\"true\""), (0, 0));
    // The ESI would say that it is.
    assert_eq!(guesses(" DataLinkLayer=\"0\""), (1, 1));
}

#[test]
fn mapping_units_that_the_file_does_not_have_are_told() {
    let managers = "<Sm StartAddress=\"#x1000\" ControlByte=\"#x64\" DefaultSize=\"1\" Enable=\"1\">Outputs</Sm>\
        <Sm StartAddress=\"#x1100\" ControlByte=\"#x20\" DefaultSize=\"1\" Enable=\"1\">Inputs</Sm>";
    let told = |units: &str| {
        let imported = imported(file("", "", &format!("{units}{managers}")));
        let told = whats(&imported, NoteKind::Guessed).into_iter().map(str::to_owned).collect::<Vec<_>>();
        (told, imported.report.lost())
    };
    let fmmu = |name: &str| format!("<Fmmu>{name}</Fmmu>");
    assert_eq!(told(&(fmmu("Outputs") + &fmmu("Inputs"))), (vec![], 0));
    assert_eq!(told(&fmmu("Inputs")), (vec!["Fmmu `outputs`".to_owned()], 0));
    assert_eq!(told(&fmmu("Outputs")), (vec!["Fmmu `inputs`".to_owned()], 0));
    // In the other order the second one is none that is made.
    assert_eq!(told(&(fmmu("Inputs") + &fmmu("Outputs"))), (vec!["Fmmu `outputs`".to_owned()], 1));
}

#[test]
fn an_encoding_that_is_not_read_is_refused_with_the_way_out() {
    // In GB 2312, two bytes are a Chinese letter.
    let declared = |name: &str| {
        let xml = format!("<?xml version='1.0' encoding='{name}'?>{}", file("", "", ""));
        let (head, tail) = xml.split_once("Tee").expect("a name");
        import(&[head.as_bytes(), b"\xCB\xC5", tail.as_bytes()].concat(), "file.xml", &Choice::default())
    };
    let refusal = declared("gb2312").expect_err("a refusal");
    assert_eq!(refusal.place, Some((1, 1)));
    assert!(refusal.why.contains("iconv -f gb2312 -t UTF-8"), "{}", refusal.why);
    assert!(declared("ISO8859-1").is_ok());
}

#[test]
fn more_than_a_mapping_object_holds_is_refused_with_its_place() {
    let pdo = |entries: usize| {
        let entry = "<Entry><Index>#x2000</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><DataType>UINT</DataType></Entry>";
        let pdo = format!(
            "\n<RxPdo Fixed=\"1\"><Index>#x1600</Index><Name>P</Name>{}</RxPdo>",
            entry.repeat(entries)
        );
        import(file("", &value("#x2000", "UINT", 16, ""), &pdo).as_bytes(), "file.xml", &Choice::default())
    };
    // Subindices 1 to 254, CiA 301.
    assert!(pdo(254).is_ok());
    let refusal = pdo(255).expect_err("a refusal");
    assert!(refusal.place.is_some() && refusal.why.contains("0x1600 has 255 entries"), "{}", refusal.why);
}

#[test]
fn an_assignment_of_a_type_that_is_not_declared_is_one_without_entries() {
    let kind = "<DataType><Name>DT1C10</Name><BitSize>16</BitSize><SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name>\
        <Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem><SubItem><Name>Elements</Name><Type>NONE</Type>\
        <BitSize>0</BitSize><BitOffs>16</BitOffs></SubItem></DataType>";
    let object = "<Object><Index>#x1C10</Index><Name>SM 0 Assignment</Name><Type>DT1C10</Type><BitSize>16</BitSize></Object>";
    let imported = imported(file("", object, "").replacen("<DataTypes>", &format!("<DataTypes>{kind}"), 1));
    assert!(imported.files["device.toml"].contains("0x1C10 = "), "{}", imported.files["device.toml"]);
}

/// ETG.1020 has bits in 0x1800 and what follows that say whether a TxPDO is valid, which are mapped in it.
#[test]
fn the_state_of_a_pdo_is_mapped_in_it() {
    let kind = "<DataType><Name>DT1800</Name><BitSize>17</BitSize><SubItem><SubIdx>0</SubIdx><Name>N</Name><Type>USINT</Type>\
        <BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem><SubItem><SubIdx>7</SubIdx><Name>State</Name><Type>BOOL</Type>\
        <BitSize>1</BitSize><BitOffs>16</BitOffs><Flags><Access>ro</Access><PdoMapping>T</PdoMapping></Flags></SubItem></DataType>\
        <DataType><Name>BOOL</Name><BitSize>1</BitSize></DataType>";
    let parameter =
        "<Object><Index>#x1800</Index><Name>Status</Name><Type>DT1800</Type><BitSize>17</BitSize></Object>";
    let state = "<Entry><Index>#x1800</Index><SubIndex>7</SubIndex><BitLen>1</BitLen><Name>State</Name><DataType>BOOL</DataType></Entry>";
    let pdo = format!("<TxPdo Fixed=\"1\"><Index>#x1A00</Index><Name>P</Name>{state}</TxPdo>");
    let xml = file("", parameter, &pdo).replacen("<DataTypes>", &format!("<DataTypes>{kind}"), 1);
    let (xml, _) = compiled(&imported(xml)).expect("an ESI");
    let device = &devc_tests::esi_reader::read(&xml).expect("an ESI").devices[0];
    let mapped = device.tx_pdos[0].entries.iter().map(|entry| (entry.index, entry.subindex, entry.bits));
    assert_eq!(mapped.collect::<Vec<_>>(), [(0x1800, Some(7), 1)]);
}

#[test]
fn what_a_profile_says_is_not_said_again() {
    let object = value("#x1009", "ARRAY [0..9] OF BYTE", 80, "");
    let (made, _) = compiled(&imported(file("", &object, ""))).expect("an ESI");
    assert!(made.contains(">The version of the hardware.</Comment>"), "{made}");
    let again = imported(made);
    assert!(!again.files["device.toml"].contains("about"), "{}", again.files["device.toml"]);
}

#[test]
fn a_mapping_object_of_the_same_name_is_not_what_is_mapped() {
    let object = value("#x7000", "UINT", 16, "<PdoMapping>R</PdoMapping>").replace("Value #x7000", "Outputs");
    let mapping =
        "<Object><Index>#x1600</Index><Name>Outputs</Name><Type>DTM</Type><BitSize>144</BitSize></Object>";
    let entry = "<Entry><Index>#x7000</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Outputs</Name><DataType>UINT</DataType></Entry>";
    let pdo = format!("<RxPdo Fixed=\"1\"><Index>#x1600</Index><Name>P</Name>{entry}</RxPdo>");
    let (xml, _) = compiled(&imported(file("", &(object + mapping), &pdo))).expect("an ESI");
    let device = &devc_tests::esi_reader::read(&xml).expect("an ESI").devices[0];
    assert_eq!(device.rx_pdos[0].entries.iter().map(|entry| entry.index).collect::<Vec<_>>(), [0x7000]);
}
