//! Modules in slots, and choices of PDOs that a tool has names for.

use devc::import::{Choice, Imported, NoteKind, import};
use devc::model::Index;

use super::sheets::{compiled, description};

/// A device with two slots, 0x800 and 0x10 apart, of which each has an axis as its module by default.
fn two_axes() -> String {
    let slot = |name: &str| {
        format!(
            "<Slot MinInstances=\"1\" MaxInstances=\"1\"><Name>{name}</Name><ModuleIdent Default=\"1\">#x100</ModuleIdent>\
             <ModuleIdent>#x200</ModuleIdent></Slot>"
        )
    };
    let word = |index: &str, access: &str| {
        format!(
            "<Object><Index DependOnSlot=\"1\">{index}</Index><Name>Word {index}</Name><Type>UINT</Type><BitSize>16</BitSize>\
             <Flags><Access>{access}</Access></Flags></Object>"
        )
    };
    let pdo = |tag: &str, index: &str, sm: u8, object: &str| {
        format!(
            "<{tag} Fixed=\"1\" Sm=\"{sm}\"><Index DependOnSlot=\"1\">{index}</Index><Name>{tag}</Name><Entry>\
             <Index DependOnSlot=\"1\">{object}</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>W</Name>\
             <DataType>UINT</DataType></Entry></{tag}>"
        )
    };
    let module = |ident: &str, inside: String| {
        format!("<Module><Type ModuleIdent=\"{ident}\">M</Type><Name>M</Name>{inside}</Module>")
    };
    let drive = [
        pdo("RxPdo", "#x1600", 2, "#x6040"),
        pdo("TxPdo", "#x1A00", 3, "#x6041"),
        format!(
            "<Profile><ProfileNo>402</ProfileNo><Dictionary><DataTypes><DataType><Name>UINT</Name><BitSize>16</BitSize>\
             </DataType></DataTypes><Objects>{}{}</Objects></Dictionary></Profile>",
            word("#x6040", "rw"),
            word("#x6041", "ro")
        ),
    ]
    .concat();
    let managers = [("MBoxOut", 0x1000, 0x26), ("MBoxIn", 0x1100, 0x22), ("Outputs", 0x1200, 0x64), ("Inputs", 0x1400, 0x20)]
        .map(|(name, at, control)| {
            let size = if name.starts_with("MBox") { 256 } else { 4 };
            format!(
                "<Sm DefaultSize=\"{size}\" StartAddress=\"#x{at:X}\" ControlByte=\"#x{control:X}\" Enable=\"1\">{name}</Sm>"
            )
        })
        .concat();
    format!(
        "<EtherCATInfo><Vendor><Id>#xE0F</Id><Name>Example</Name></Vendor><Descriptions><Devices>\
         <Device Physics=\"YY\"><Type ProductCode=\"#x1\" RevisionNo=\"#x2\">T-1</Type><Name>Tee</Name>\
         <GroupType>G</GroupType>{managers}<Mailbox><CoE/></Mailbox>\
         <Slots SlotPdoIncrement=\"16\" SlotIndexIncrement=\"#x800\">{}{}</Slots></Device></Devices>\
         <Modules>{}{}</Modules></Descriptions></EtherCATInfo>",
        slot("Left"),
        slot("Right"),
        module("#x100", drive),
        module("#x200", String::new())
    )
}

fn imported(xml: &str) -> Imported {
    import(xml.as_bytes(), "file.xml", &Choice::default()).expect("an import")
}

fn lost(imported: &Imported) -> Vec<&str> {
    let notes = imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    notes.map(|note| note.what.as_str()).collect()
}

#[test]
fn modules_of_slots_are_axes() {
    let imported = imported(&two_axes());
    let text = description(&imported);
    assert!(text.contains("names  = [\"Left\", \"Right\"]"), "{text}");
    assert!(text.contains("[modules.0x00000100]"), "{text}");
    let device = compiled(&imported);
    let indices: Vec<u16> = device.pdos.iter().map(|pdo| pdo.index.0).collect();
    assert_eq!(indices, [0x1600, 0x1610, 0x1A00, 0x1A10], "{text}");
    assert!(device.object(Index(0x6840)).is_some() && device.object(Index(0x6841)).is_some());
    // Which module could be there instead.
    let others = lost(&imported).into_iter().filter(|what| *what == "Slot/ModuleIdent").count();
    assert_eq!(others, 2, "{:?}", lost(&imported));
}

#[test]
fn slots_that_are_open_are_no_axes() {
    let open = two_axes().replace(" Default=\"1\"", "");
    let imported = imported(&open);
    assert_eq!(lost(&imported), Vec::<&str>::new());
    let text = description(&imported);
    assert!(!text.contains("0x6040"), "{text}");
    for said in ["[slots.left]", "[slots.right]", "modules    = [0x00000100, 0x00000200]"] {
        assert!(text.contains(said), "{said}: {text}");
    }
}

/// TwinCAT offers choices of PDOs by name; what else is for it alone is lost.
#[test]
fn choices_with_names_are_configurations() {
    let choice = |name: &str, pdo: &str| {
        format!(
            "<AlternativeSmMapping><Name>{name}</Name><Sm No=\"0\"><Pdo>{pdo}</Pdo></Sm></AlternativeSmMapping>"
        )
    };
    let pdo = |index: &str, sm: &str| {
        format!(
            "<TxPdo Fixed=\"1\"{sm}><Index>{index}</Index><Name>P {index}</Name><Entry><Index>#x2000</Index>\
             <SubIndex>0</SubIndex><BitLen>16</BitLen><Name>V</Name><DataType>UINT</DataType></Entry></TxPdo>"
        )
    };
    let xml = format!(
        "<EtherCATInfo><Vendor><Id>#xE0F</Id><Name>Example</Name></Vendor><Descriptions><Devices>\
         <Device Physics=\"YY\"><Type ProductCode=\"#x1\" RevisionNo=\"#x2\">T-1</Type><Name>Tee</Name>\
         <Info><VendorSpecific><TwinCAT>{}{}{}</TwinCAT><Other>1</Other></VendorSpecific></Info><GroupType>G</GroupType>\
         <Sm DefaultSize=\"2\" StartAddress=\"#x1100\" ControlByte=\"#x20\" Enable=\"1\">Inputs</Sm>{}{}\
         </Device></Devices></Descriptions></EtherCATInfo>",
        choice("Short form", "#x1A00"),
        choice("Long form", "#x1A01"),
        choice("Unknown", "#x1A02"),
        pdo("#x1A00", " Sm=\"0\""),
        pdo("#x1A01", "")
    );
    let imported = imported(&xml);
    let device = compiled(&imported);
    let choices = device.configurations.iter().map(|it| (it.name.as_str(), it.inputs.clone()));
    let expected = [("Short form", Some(vec![Index(0x1A00)])), ("Long form", Some(vec![Index(0x1A01)]))];
    assert_eq!(choices.collect::<Vec<_>>(), expected, "{}", description(&imported));
    assert_eq!(lost(&imported), ["AlternativeSmMapping `Unknown`", "VendorSpecific/Other"]);
}
