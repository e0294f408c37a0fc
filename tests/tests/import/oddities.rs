//! What files of other makers have that those at hand have not: small files with one oddity each.

use devc::import::{Choice, Imported, NoteKind, import};

use super::round_trip::{compiled, trip};
use super::transport::{file, text, value, whole};

/// What is said of an import: what it is, and why.
fn notes(imported: &Imported, kind: NoteKind) -> Vec<(&str, &str)> {
    let notes = imported.report.notes.iter().filter(|note| note.kind == kind);
    notes.map(|note| (note.what.as_str(), note.why.as_str())).collect()
}

fn imported(xml: &str) -> Imported {
    import(xml.as_bytes(), "drive.xml", &Choice::default()).expect("a description")
}

/// Hot connect and the commands of process data, ETG.2000: what a master does by them is in the EEPROM as well.
#[test]
fn what_a_master_asks_and_which_commands_it_uses_are_kept() {
    let info = "<Info><IdentificationAdo>#x0012</IdentificationAdo><IdentificationReg134>true</IdentificationReg134></Info>";
    let xml = file("", "", "").replace("<GroupType>", &format!("{info}<GroupType>"));
    let trip = whole(&xml.replace("<Type ", "<Type UseLrdLwr=\"1\" "));
    for said in ["no-lrw    = true", "requested-id = true", "id-address   = 0x0012"] {
        assert!(text(&trip).contains(said), "{said}: {}", text(&trip));
    }
}

#[test]
fn what_says_that_nothing_is_so_says_nothing() {
    let info = "<Info><IdentificationReg134>false</IdentificationReg134></Info>";
    let eeprom =
        "<Eeprom AssignToPdi=\"0\"><ByteSize>2048</ByteSize><ConfigData>050C0304E803</ConfigData></Eeprom>";
    let xml = file("", "", eeprom).replace("<GroupType>", &format!("{info}<GroupType>"));
    let imported = imported(&xml.replace("<Type ", "<Type UseLrdLwr=\"0\" "));
    assert_eq!(notes(&imported, NoteKind::Lost), []);
}

/// Ports that are none are a loss as any other, and no reason to refuse the device.
#[test]
fn ports_that_are_none_are_lost() {
    for (written, taken) in [("yk", "YK"), ("YY ", "YY"), ("MII", "YY"), ("", "YY"), ("1", "YY")] {
        let imported =
            imported(&file("", "", "").replace("Physics=\"YY\"", &format!("Physics=\"{written}\"")));
        let toml: String = imported.files.values().map(String::as_str).collect();
        assert!(toml.contains(&format!("physics   = \"{taken}\"")), "{written}: {toml}");
        let is_lost = notes(&imported, NoteKind::Lost).iter().any(|(what, _)| *what == "Device/@Physics");
        let is_guessed = notes(&imported, NoteKind::Guessed).iter().any(|(what, _)| *what == "Physics");
        let is_none = ["MII", "", "1"].contains(&written);
        assert_eq!((is_lost, is_guessed), (is_none, is_none), "{written}");
        compiled(&imported).expect("an ESI");
    }
}

/// A PDO of the device itself is in no slot.
#[test]
fn slots_that_are_none_decide_nothing() {
    let object = value("#x2000", "UINT", 16, "<PdoMapping>T</PdoMapping>");
    let pdo = "<TxPdo><Index DependOnSlot=\"true\">#x1A00</Index><Name>P</Name><Entry><Index DependOnSlot=\"1\">#x2000</Index>\
        <SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Value #x2000</Name><DataType>UINT</DataType></Entry></TxPdo>";
    whole(&file("", &object, pdo));
}

/// A row of bits is one, whatever it is called (ETG.1000.6); what is called otherwise is told.
#[test]
fn a_row_of_bits_that_is_only_mapped_is_taken_for_its_bytes() {
    let pdo = "<TxPdo Fixed=\"1\"><Index>#x1A00</Index><Name>P</Name><Entry><Index>#x3101</Index>\
        <SubIndex>1</SubIndex><BitLen>8</BitLen><Name>Valves</Name><DataType>BITARR8</DataType></Entry></TxPdo>";
    let trip = trip(file("", "", pdo).as_bytes(), 1).expect("a round trip");
    assert_eq!(notes(&trip.imported, NoteKind::Lost), []);
    assert!(text(&trip).contains("type = \"BYTE\""), "{}", text(&trip));
    let told = ("the data type of a mapped entry", "`BITARR8` is taken for BYTE");
    assert!(notes(&trip.imported, NoteKind::Guessed).contains(&told));
}

/// A text without length is none that could be sent; that it gets one is told.
#[test]
fn a_text_of_no_length_gets_one_and_it_is_said() {
    let object = value("#x2000", "STRING(0)", 0, "");
    let xml = file("", &object, "")
        .replace("<DataTypes>", "<DataTypes><DataType><Name>STRING(0)</Name><BitSize>0</BitSize></DataType>");
    let imported = imported(&xml);
    let told = notes(&imported, NoteKind::Guessed);
    assert!(
        told.iter().any(|(what, why)| *what == "the type of 0x2000" && why.ends_with("STRING(1)")),
        "{told:?}"
    );
}

/// Names that count need one line, with zeros in front as well.
#[test]
fn names_that_count_with_zeros_in_front_are_said_once() {
    let object = "<Object><Index>#x2000</Index><Name>Messages</Name><Type>DTM</Type><BitSize>80</BitSize>\
        <Flags><Access>ro</Access></Flags></Object>";
    for (first, second, said) in [("009", "010", "{+8:03}"), ("01", "02", "{:02}"), ("9", "10", "{+8}")] {
        let xml = file("", object, "").replace("SubIndex 001", &format!("Message {first}"));
        let trip = trip(xml.replace("SubIndex 002", &format!("Message {second}")).as_bytes(), 1)
            .expect("a round trip");
        assert!(
            text(&trip).contains(&format!("\"1..=2\" = {{ name = \"Message {said}\"")),
            "{said}: {}",
            text(&trip)
        );
        assert_eq!(trip.silent, Vec::<String>::new());
    }
}
