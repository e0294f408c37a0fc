//! Names in the objects that follow from PDOs and sync managers, and of subindex 0.

use devc::import::{Choice, Imported, NoteKind, import};

use super::round_trip::{compiled, trip};
use super::transport::{file, value};

/// What is lost, with how many facts each is.
fn lost(imported: &Imported) -> Vec<(&str, usize)> {
    let lost = imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    lost.map(|note| (note.what.as_str(), note.facts)).collect()
}

/// A type of two members of so many bits after subindex 0, with these names.
fn members(name: &str, kind: &str, bits: u32, names: [&str; 3]) -> String {
    let member = |(subindex, name): (u32, &&str)| {
        let (kind, bits, place) =
            if subindex == 0 { ("USINT", 8, 0) } else { (kind, bits, 16 + (subindex - 1) * bits) };
        format!(
            "<SubItem><SubIdx>{subindex}</SubIdx><Name>{name}</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>\
             <BitOffs>{place}</BitOffs><Flags><Access>ro</Access></Flags></SubItem>"
        )
    };
    let members: String = (0..).zip(&names).map(member).collect();
    format!("<DataType><Name>{name}</Name><BitSize>{}</BitSize>{members}</DataType>", 16 + 2 * bits)
}

/// A device with a PDO that maps `Speed` and `Load`, whose mapping object has these names.
fn mapping(fixed: u8, names: [&str; 3]) -> Imported {
    let kind = members("DT1600", "UDINT", 32, names);
    let values: String = [("#x2000", "Speed"), ("#x2001", "Load")]
        .map(|(index, name)| {
            value(index, "UINT", 16, "<PdoMapping>R</PdoMapping>").replace(&format!("Value {index}"), name)
        })
        .concat();
    let object =
        "<Object><Index>#x1600</Index><Name>P</Name><Type>DT1600</Type><BitSize>80</BitSize></Object>";
    let entry = |index: &str, name: &str| {
        format!(
            "<Entry><Index>{index}</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>{name}</Name>\
             <DataType>UINT</DataType></Entry>"
        )
    };
    let entries = entry("#x2000", "Speed") + &entry("#x2001", "Load");
    let pdo = format!(
        "<RxPdo Fixed=\"{fixed}\"><Index>#x1600</Index><Name>P</Name>{entries}</RxPdo>\
        <Mailbox DataLinkLayer=\"1\"><CoE PdoConfig=\"1\"/></Mailbox>"
    );
    let xml = file("", &(object.to_owned() + &values), &pdo);
    imported(&xml.replacen("<DataTypes>", &format!("<DataTypes>{kind}"), 1))
}

fn imported(xml: &str) -> Imported {
    import(xml.as_bytes(), "drive.xml", &Choice::default()).expect("an import")
}

#[test]
fn names_in_mapping_objects_are_told_once_for_each() {
    let fixed = |names| lost(&mapping(1, names)).iter().map(|(_, facts)| *facts).sum::<usize>();
    // What is mapped is called so, or the name says nothing.
    assert_eq!(fixed(["SubIndex 000", "Speed", "Load"]), 0);
    assert_eq!(fixed(["Highest subindex supported", "SubIndex 001", "SubIndex 002"]), 0);
    assert_eq!(fixed(["SubIndex 000", "Speed", "Output Object 2"]), 1);
    let all = mapping(1, ["Number of elements", "Output Object 1", "Output Object 2"]);
    assert_eq!(lost(&all), [("names in a mapping object", 3)]);
    assert!(all.report.text("file.xml").contains("names in a mapping object, 3 facts, at "));
    let json = all.report.json("file.xml");
    assert!(json.contains("\"facts\": 3"), "{json}");
    // What lies behind a place of a free mapping changes, so that the place has a number.
    assert_eq!(lost(&mapping(0, ["SubIndex 000", "Speed", "Load"])), [("names in a mapping object", 2)]);
    assert_eq!(lost(&mapping(0, ["SubIndex 000", "SubIndex 001", "SubIndex 002"])), []);
}

#[test]
fn what_lists_pdos_is_an_array_and_has_numbers() {
    let device = |names| {
        let kind = members("DT1C12", "UINT", 16, names);
        let object = "<Object><Index>#x1C12</Index><Name>Sync manager 2 PDO assignment</Name><Type>DT1C12</Type><BitSize>48</BitSize></Object>";
        let manager = |role: &str, place: u32, control: &str| {
            format!(
                "<Sm StartAddress=\"{place}\" ControlByte=\"{control}\" DefaultSize=\"128\" Enable=\"1\">{role}</Sm>"
            )
        };
        let managers = [
            manager("MBoxOut", 4096, "#x26"),
            manager("MBoxIn", 4352, "#x22"),
            manager("Outputs", 4608, "#x64"),
        ];
        imported(&file("", object, &managers.concat()).replacen(
            "<DataTypes>",
            &format!("<DataTypes>{kind}"),
            1,
        ))
    };
    let kind = ("the kind of an assignment object", 0);
    assert_eq!(lost(&device(["SubIndex 000", "SubIndex 001", "SubIndex 002"])), [kind]);
    let named = device(["SubIndex 000", "First PDO", "Second PDO"]);
    assert_eq!(lost(&named), [("names in an assignment object", 2), kind]);
}

/// ETG.1000.6: subindex 0 counts the others. A name that says so in other words is told, any other is kept.
#[test]
fn the_name_of_subindex_0_is_kept_or_told() {
    let record = |name| {
        let kind = members("DT2000", "UINT", 16, [name, "Gain", "Offset"]);
        let object = "<Object><Index>#x2000</Index><Name>Scale</Name><Type>DT2000</Type><BitSize>48</BitSize></Object>";
        file("", object, "").replacen("<DataTypes>", &format!("<DataTypes>{kind}"), 1)
    };
    assert_eq!(lost(&imported(&record("SubIndex 000"))), []);
    for told in ["Number of elements", "largest sub-index supported", "Max SubIndex", "No of Entries"] {
        assert_eq!(lost(&imported(&record(told))), [("the name of subindex 0", 1)], "{told}");
    }
    let kept = imported(&record("Coupler table"));
    assert_eq!(lost(&kept), []);
    let (made, _) = compiled(&kept).expect("an ESI");
    assert_eq!(made.matches("<Name>Coupler table</Name>").count(), 2, "in the type and in the object");
    assert_eq!(trip(made.as_bytes(), 1).expect("a description").imported.files, kept.files);
}
