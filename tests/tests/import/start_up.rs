//! Start-up commands: what is a choice with a key of its own is said by that, all else as it is written.

use devc::import::NoteKind;

use super::round_trip::{Trip, trip};
use super::transport::{file, text, value, whole};

fn command(index: u16, subindex: u8, data: &str, comment: &str) -> String {
    let comment = if comment.is_empty() { String::new() } else { format!("<Comment>{comment}</Comment>") };
    format!(
        "<InitCmd><Transition>PS</Transition><Index>#x{index:04x}</Index><SubIndex>{subindex}</SubIndex>\
         <Data>{data}</Data>{comment}</InitCmd>\n"
    )
}

/// A drive of so many axes with modes, cycle times and a value of its own; two PDOs are free and one is assigned.
fn drive(axes: u16, commands: &str) -> String {
    let axis = |axis: u16| {
        let at = |index: u16| format!("#x{:04x}", index + axis * 0x800);
        let words = [at(0x6040), at(0x6041)].map(|at| value(&at, "UINT", 16, "<PdoMapping>RT</PdoMapping>"));
        let [low, high] = [at(0x60C2), at(0x607A)];
        let period = format!(
            "<Object><Index>{low}</Index><Name>Time</Name><Type>DTP</Type><BitSize>32</BitSize></Object>"
        );
        let target = value(&high, "UDINT", 32, "<PdoMapping>R</PdoMapping>");
        [words.concat(), value(&at(0x6060), "USINT", 8, ""), period, target].concat()
    };
    let objects: String = (0..axes).map(axis).chain([value("#x2000", "UINT", 16, "")]).collect();
    let pdo = |index: &str, sm: &str, entry: &str, bits: u8| {
        format!(
            "<RxPdo{sm}><Index>{index}</Index><Name>P {index}</Name><Entry><Index>{entry}</Index>\
             <SubIndex>0</SubIndex><BitLen>{bits}</BitLen></Entry></RxPdo>"
        )
    };
    let managers = "<Sm StartAddress=\"#x1000\" ControlByte=\"#x26\" Enable=\"1\">MBoxOut</Sm>\
        <Sm StartAddress=\"#x1100\" ControlByte=\"#x22\" Enable=\"1\">MBoxIn</Sm>\
        <Sm StartAddress=\"#x1200\" ControlByte=\"#x64\" Enable=\"1\">Outputs</Sm>";
    let pdos = pdo("#x1600", " Sm=\"2\"", "#x6040", 16) + &pdo("#x1601", "", "#x607a", 32);
    let mailbox = format!("<Mailbox><CoE PdoAssign=\"1\" PdoConfig=\"1\">{commands}</CoE></Mailbox>");
    let file = file("", &objects, &[managers, &pdos, &mailbox].concat());
    file.replace("<DataTypes>", &format!("<DataTypes>{PERIOD}"))
}

/// A record of a count and of a power of ten.
const PERIOD: &str = "<DataType><Name>SINT</Name><BitSize>8</BitSize></DataType><DataType><Name>DTP</Name><BitSize>32</BitSize>\
    <SubItem><SubIdx>0</SubIdx><Name>N</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs></SubItem>\
    <SubItem><SubIdx>1</SubIdx><Name>Count</Name><Type>USINT</Type><BitSize>8</BitSize><BitOffs>16</BitOffs>\
    <Flags><Access>rw</Access></Flags></SubItem>\
    <SubItem><SubIdx>2</SubIdx><Name>Exponent</Name><Type>SINT</Type><BitSize>8</BitSize><BitOffs>24</BitOffs>\
    <Flags><Access>rw</Access></Flags></SubItem></DataType>";

/// The configuration of a description, without the names of its table.
fn configuration(trip: &Trip) -> String {
    let text = text(trip);
    let from = text.find("[configurations.start-up]").unwrap_or_else(|| panic!("{text}"));
    let rest = &text[from..];
    rest[..rest.find("\n\n").unwrap_or(rest.len())].split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_mode_and_a_cycle_time_are_said_by_their_keys() {
    let commands =
        [command(0x6060, 0, "FE", ""), command(0x60C2, 1, "02", ""), command(0x60C2, 2, "fd", "")].concat();
    let said = configuration(&whole(&drive(1, &commands)));
    assert!(said.ends_with("default = true mode = -2 cycle-time = \"2 ms\""), "{said}");
}

#[test]
fn what_else_is_written_stays_behind() {
    let commands = command(0x6060, 0, "08", "") + &command(0x2000, 0, "0A00", "Why");
    let said = configuration(&whole(&drive(1, &commands)));
    assert!(said.contains("mode = 8") && said.contains("value = 10, why = \"Why\""), "{said}");
    // What comes before a mode may be what it takes to set it.
    let commands = command(0x2000, 0, "0A00", "Why") + &command(0x6060, 0, "08", "");
    let said = configuration(&whole(&drive(1, &commands)));
    assert!(!said.contains("mode =") && said.contains("entry = \"modes-of-operation\""), "{said}");
}

#[test]
fn what_a_key_would_write_otherwise_stays_as_it_is() {
    // 20 units of 100 us are what 2 ms are, but not what is written for them.
    let commands = command(0x60C2, 1, "14", "") + &command(0x60C2, 2, "fc", "");
    let said = configuration(&whole(&drive(1, &commands)));
    assert!(!said.contains("cycle-time") && said.contains("value = 20"), "{said}");
    let half = command(0x60C2, 1, "02", "");
    assert!(!configuration(&whole(&drive(1, &half))).contains("cycle-time"));
}

#[test]
fn a_choice_is_the_same_for_all_axes() {
    let both = command(0x6060, 0, "08", "") + &command(0x6860, 0, "08", "");
    assert!(configuration(&whole(&drive(2, &both))).contains("mode = 8"));
    let trip = trip(drive(2, &command(0x6060, 0, "08", "")).as_bytes(), 1).expect("a round trip");
    let said = configuration(&trip);
    assert!(trip.silent.is_empty() && !said.contains("mode =") && said.contains("value = 8"), "{said}");
}

#[test]
fn what_a_key_does_not_tell_of_a_command_is_lost() {
    let trip = trip(drive(1, &command(0x6060, 0, "08", "Needs firmware 3")).as_bytes(), 1).expect("a trip");
    assert!(configuration(&trip).contains("mode = 8"));
    let lost = trip.imported.report.notes.iter().filter(|note| note.kind == NoteKind::Lost);
    let lost: Vec<_> = lost.map(|note| (note.what.as_str(), note.why.as_str(), note.facts)).collect();
    assert_eq!(lost, [("InitCmd/Comment", "`Needs firmware 3`: `mode` says what is written", 1)]);
}

#[test]
fn assignments_and_mappings_are_keys_where_the_pdos_say_otherwise() {
    let other = [
        command(0x1C12, 0, "00", ""),
        command(0x1601, 0, "00", ""),
        command(0x1601, 1, "10004060", ""),
        command(0x1601, 2, "20007A60", ""),
        command(0x1601, 0, "02", ""),
        command(0x1C12, 1, "0116", ""),
        command(0x1C12, 0, "01", ""),
    ];
    let trip = trip(drive(1, &other.concat()).as_bytes(), 1).expect("a round trip");
    let said = configuration(&trip);
    assert!(said.contains("outputs = [\"0x1601\"]"), "{said}");
    assert!(said.contains("0x1601 = [\"controlword\", \"target-position\"]"), "{said}");
    assert_eq!(trip.silent, Vec::<String>::new());
    assert_eq!(trip.imported.report.lost(), 0);
}

#[test]
fn what_the_pdos_say_anyway_is_not_said_again() {
    let complete = "<InitCmd CompleteAccess=\"1\"><Transition>PS</Transition><Index>#x1c12</Index><SubIndex>0</SubIndex>\
        <Data>01000016</Data></InitCmd>";
    let trip = trip(drive(1, complete).as_bytes(), 1).expect("a round trip");
    assert!(!text(&trip).contains("[configurations"), "{}", text(&trip));
    assert_eq!((trip.imported.report.lost(), trip.silent.len()), (0, 0));
}

#[test]
fn what_no_master_may_choose_is_lost() {
    let counted = command(0x1C12, 1, "0116", "") + &command(0x1C12, 0, "01", "");
    let closed = drive(1, &counted).replace("PdoAssign=\"1\"", "PdoAssign=\"0\"");
    let told = |xml: &str| {
        let trip = trip(xml.as_bytes(), 1).expect("a round trip");
        let lost = trip.imported.report.notes.into_iter().filter(|note| note.what.starts_with("InitCmd"));
        lost.map(|note| note.why).collect::<Vec<_>>()
    };
    assert!(told(&closed).iter().all(|why| why.starts_with("the mailbox says")), "{:?}", told(&closed));
    let unknown = told(&drive(1, &counted.replace("0116", "0916")));
    assert!(unknown.iter().all(|why| why.starts_with("it assigns a PDO that is not there")), "{unknown:?}");
    assert_eq!(unknown.len(), 2);
}
