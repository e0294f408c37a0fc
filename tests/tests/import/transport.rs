//! What carries data: sync managers in any order, the mailbox, timeouts, start-up commands, and what follows from them.

use devc::import::{Choice, NoteKind, import};

use super::round_trip::{Trip, trip};

/// A file with the parts of one device around its dictionary.
pub(super) fn file(before: &str, objects: &str, after: &str) -> String {
    let uint =
        |name: &str, bits: u32| format!("<DataType><Name>{name}</Name><BitSize>{bits}</BitSize></DataType>");
    let types =
        [uint("UINT", 16), uint("USINT", 8), uint("UDINT", 32), uint("ARRAY [0..9] OF BYTE", 80)].concat();
    format!(
        "<EtherCATInfo><Vendor><Id>#xE0F</Id><Name>Example</Name></Vendor><Descriptions><Devices>\n\
         <Device Physics=\"YY\"><Type ProductCode=\"#x1\" RevisionNo=\"#x2\">T-1</Type>{before}<Name>Tee</Name>\n\
         <GroupType>G</GroupType><Profile><Dictionary><DataTypes>{types}{RECORD}</DataTypes><Objects>{objects}</Objects>\n\
         </Dictionary></Profile>{after}</Device></Devices></Descriptions></EtherCATInfo>"
    )
}

/// A mapping object with room for four entries.
const RECORD: &str = "<DataType><Name>DTM</Name><BitSize>144</BitSize>\
    <SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs>\
    <Flags><Access>ro</Access></Flags></SubItem>\
    <SubItem><SubIdx>1</SubIdx><Name>SubIndex 001</Name><Type>UDINT</Type><BitSize>32</BitSize><BitOffs>16</BitOffs>\
    <Flags><Access>ro</Access><Category>o</Category><Setting>1</Setting></Flags></SubItem>\
    <SubItem><SubIdx>2</SubIdx><Name>SubIndex 002</Name><Type>UDINT</Type><BitSize>32</BitSize><BitOffs>48</BitOffs>\
    <Flags><Access>ro</Access><Category>o</Category><Setting>1</Setting></Flags></SubItem></DataType>";

pub(super) fn value(index: &str, kind: &str, bits: u32, flags: &str) -> String {
    format!(
        "<Object><Index>{index}</Index><Name>Value {index}</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>\
         <Flags><Access>rw</Access>{flags}</Flags></Object>\n"
    )
}

pub(super) fn text(trip: &Trip) -> String {
    trip.imported.files.values().map(String::as_str).collect()
}

/// Nothing changed on the way, and nothing is lost.
#[track_caller]
pub(super) fn whole(xml: &str) -> Trip {
    let trip = trip(xml.as_bytes(), 1).expect("a round trip");
    assert_eq!(trip.changed, [], "{}", text(&trip));
    let lost = trip.imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    assert_eq!(lost.map(|note| &note.what).collect::<Vec<_>>(), Vec::<&String>::new());
    trip
}

#[test]
fn sync_managers_may_be_in_any_order_and_number() {
    let pdo = |tag: &str, index: &str, sm: u32| {
        format!(
            "<{tag} Fixed=\"1\" Sm=\"{sm}\" Su=\"0\"><Index>{index}</Index><Name>P {index}</Name><Entry><Index>#x2000</Index>\
             <SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Value #x2000</Name><DataType>UINT</DataType></Entry></{tag}>\n"
        )
    };
    let managers = "<Fmmu Sm=\"1\">Inputs</Fmmu><Fmmu Sm=\"2\">Inputs</Fmmu>\
        <Sm MinSize=\"1\" MaxSize=\"8\" DefaultSize=\"0\" StartAddress=\"#x1000\" ControlByte=\"#x64\" Enable=\"1\" OpOnly=\"1\">Outputs</Sm>\n\
        <Sm DefaultSize=\"2\" StartAddress=\"#x1100\" ControlByte=\"#x20\" Enable=\"1\">Inputs</Sm>\n\
        <Sm DefaultSize=\"2\" StartAddress=\"#x1200\" ControlByte=\"#x00\" Enable=\"0\">Inputs</Sm>\n<Su>Fast</Su>";
    let managers = managers.replace("<Fmmu Sm=\"1\">", "<Fmmu>Outputs</Fmmu><Fmmu Sm=\"1\">");
    let after = [managers, pdo("TxPdo", "#x1A00", 1), pdo("TxPdo", "#x1A01", 2)].concat();
    let trip = whole(&file("", &value("#x2000", "UINT", 16, "<PdoMapping>T</PdoMapping>"), &after));
    let text = text(&trip);
    for said in [
        "[sync-managers.inputs-2]",
        "role    = \"inputs\"",
        "enable  = false",
        "op-only  = true",
        "min-size = 1",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
    // They lie in the order of the roles, so that no number is needed.
    assert!(!text.contains("number"), "{text}");
}

#[test]
fn a_number_is_said_where_the_order_does_not_tell_it() {
    let sm = |name: &str, at: u32, control: &str| {
        format!(
            "<Sm StartAddress=\"{at}\" ControlByte=\"{control}\" DefaultSize=\"8\" Enable=\"1\">{name}</Sm>\n"
        )
    };
    let after = [sm("Inputs", 4096, "#x20"), sm("Outputs", 4608, "#x64")].concat();
    let trip = whole(&file("", "", &after));
    assert!(text(&trip).contains("number  = 0"), "{}", text(&trip));
}

#[test]
fn what_a_mapping_object_has_room_for_is_kept() {
    let pdo = "<RxPdo Fixed=\"1\"><Index>#x1600</Index><Name>P</Name><Entry><Index>#x2000</Index><SubIndex>0</SubIndex>\
        <BitLen>16</BitLen><Name>Value #x2000</Name><DataType>UINT</DataType></Entry></RxPdo>";
    let mapping = |index: &str, name: &str| {
        format!(
            "<Object><Index>{index}</Index><Name>{name}</Name><Type>DTM</Type><BitSize>144</BitSize></Object>\n"
        )
    };
    let objects = [
        mapping("#x1600", "Outputs of the first kind"),
        // That of a PDO which the file does not describe is an object as any other.
        mapping("#x1601", "Outputs of the second kind"),
        value("#x2000", "UINT", 16, "<PdoMapping>R</PdoMapping>"),
    ];
    let trip = whole(&file("", &objects.concat(), pdo));
    assert!(text(&trip).contains("max-entries = 2"), "{}", text(&trip));
}

#[test]
fn flags_and_bytes_are_kept() {
    let objects = [
        value("#x2000", "UINT", 16, "<Backup>1</Backup><Setting>1</Setting>"),
        value("#x2001", "ARRAY [0..9] OF BYTE", 80, ""),
    ];
    let trip = whole(&file("", &objects.concat(), ""));
    assert!(text(&trip).contains("backup = true, setting = true"), "{}", text(&trip));
    assert!(text(&trip).contains("OCTET_STRING(10)"), "{}", text(&trip));
}

#[test]
fn timeouts_start_up_and_older_revisions_are_kept() {
    let before = "<HideType RevisionNo=\"#x1\"/><Info><StateMachine><Timeout><PreopTimeout>3000</PreopTimeout>\
        <SafeopOpTimeout>10000</SafeopOpTimeout><BackToInitTimeout>5000</BackToInitTimeout>\
        <BackToSafeopTimeout>200</BackToSafeopTimeout></Timeout></StateMachine><Mailbox><Timeout>\
        <RequestTimeout>100</RequestTimeout><ResponseTimeout>2000</ResponseTimeout></Timeout></Mailbox></Info>";
    let command = |index: &str, data: &str, transition: &str| {
        format!(
            "<InitCmd><Transition>{transition}</Transition><Index>{index}</Index><SubIndex>0</SubIndex><Data>{data}</Data>\
             <Comment>Why</Comment></InitCmd>"
        )
    };
    let after = format!(
        "<Mailbox DataLinkLayer=\"1\"><EoE IP=\"1\" MAC=\"0\"/><CoE SdoInfo=\"1\" PdoUpload=\"0\">{}{}</CoE></Mailbox>",
        command("#x2000", "0A00", "PS"),
        command("#x2001", "FF", "SO")
    );
    let objects = [value("#x2000", "UINT", 16, ""), value("#x2001", "USINT", 8, "")].concat();
    let trip = whole(&file(before, &objects, &after));
    let text = text(&trip);
    for said in [
        "pre-op          = \"3 s\"",
        "\"200 ms\"",
        "replaces",
        "eoe-ip",
        "default = true",
        "transition = \"SO\"",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
}

#[test]
fn a_start_up_command_for_what_is_not_there_is_told() {
    let after = "<Mailbox><CoE><InitCmd><Transition>PS</Transition><Index>#x3000</Index><SubIndex>0</SubIndex>\
        <Data>00</Data></InitCmd></CoE></Mailbox>";
    let report =
        import(file("", "", after).as_bytes(), "file.xml", &Choice::default()).expect("an import").report;
    let note = report.notes.iter().find(|note| note.what.starts_with("InitCmd")).expect("a note");
    assert!(note.why.contains("not in the dictionary") && note.why.contains("it writes 00"), "{}", note.why);
}

#[test]
fn signals_keep_their_times() {
    let after = "<Dc><OpMode><Name>DC</Name><Desc>Clocks</Desc><AssignActivate>#x700</AssignActivate>\
        <CycleTimeSync0>1000000</CycleTimeSync0><ShiftTimeSync0 Factor=\"2\" Input=\"1\">-500</ShiftTimeSync0>\
        <CycleTimeSync1 Factor=\"-4\">0</CycleTimeSync1><ShiftTimeSync1>0</ShiftTimeSync1></OpMode></Dc>";
    let text = text(&whole(&file("", "", after)));
    for said in
        ["period = \"1 ms\"", "shift = \"-500 ns\"", "shift-cycles = 2", "of-inputs = true", "cycles = -4"]
    {
        assert!(text.contains(said), "{said}: {text}");
    }
}

#[test]
fn what_is_not_in_the_dictionary_has_its_type_in_the_pdo() {
    let entry = |index: &str, kind: &str, bits: u32| {
        format!(
            "<Entry><Index>{index}</Index><SubIndex>1</SubIndex><BitLen>{bits}</BitLen><Name>Part {index}</Name>\
             <DataType>{kind}</DataType></Entry>"
        )
    };
    let entries =
        [entry("#x6000", "BOOL", 1), entry("#x6001", "BIT7", 7), entry("#x6002", "REAL", 32)].concat();
    let pdo = format!("<TxPdo Fixed=\"1\"><Index>#x1A00</Index><Name>P</Name>{entries}</TxPdo>");
    let text = text(&whole(&file("", "", &pdo)));
    assert!(text.contains("type = \"REAL32\"") && !text.contains("bits ="), "{text}");
}
