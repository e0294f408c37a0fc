//! What `ethercat sdos` of IgH's master prints.

use devc::import::{Choice, import};
use devc::model::Index;

use super::sheets::{compiled, description};

/// As IgH's master prints it for a device: rights in Pre-Operational, Safe-Operational and Operational, then type, width and
/// name.
const LIST: &str = "=== Master 0, Slave 3 ===
SDO 0x1000, \"Device type\"
  0x1000:00, r-r-r-, uint32, 32 bit, \"Device type\"
SDO 0x1018, \"Identity\"
  0x1018:00, r-r-r-, uint8, 8 bit, \"SubIndex 000\"
  0x1018:01, r-r-r-, uint32, 32 bit, \"Vendor ID\"
SDO 0x2010, \"Ramp\"
  0x2010:00, r-r-r-, uint8, 8 bit, \"SubIndex 000\"
  0x2010:01, rwrwrw, float, 32 bit, \"Rise\"
  0x2010:02, rwr-r-, int16, 16 bit, \"Mode\"
  0x2010:0a, -w-w--, type 0031, 2 bit, \"Start\"
SDO 0x2011, \"Name\"
  0x2011:00, r-r-r-, string, 88 bit, \"Name\"
SDO 0x6040, \"Controlword\"
  0x6040:00, rwrwrw, uint16, 16 bit, \"Controlword\"
SDO 0x6041, \"Statusword\"
  0x6041:00, r-r-r-, uint16, 16 bit, \"Statusword\"
";

#[test]
fn a_list_of_sdo_information_becomes_a_dictionary() {
    let imported = import(LIST.as_bytes(), "sdos.txt", &Choice::default()).expect("an import");
    let text = description(&imported);
    assert!(text.contains("profiles = [\"ethercat\", \"cia402\"]"), "{text}");
    assert_eq!(imported.report.lost(), 0, "{:?}", imported.report);
    for line in [
        "1  = { name = \"Rise\", type = \"REAL32\" }",
        "2  = { name = \"Mode\", type = \"INT16\", written = \"pre-op\" }",
        "access = \"rw\"\n[objects.0x2010.entries]",
        "0x6040 = {}",
        "10 = { name = \"Start\", type = \"BIT2\", access = \"wo\", written = \"pre-op-safe-op\" }",
        "sdo-info  = true",
        "type = \"STRING(11)\"",
        "[documents.sdos]",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    assert_eq!(compiled(&imported).object(Index(0x2010)).expect("the ramp").entries.len(), 4);
}

/// Older masters print no rights, and several devices follow one another.
#[test]
fn a_list_without_rights_is_read_and_the_next_device_is_not() {
    let without = LIST.replace(", r-r-r-", "").replace(", rwrwrw", "");
    let without = without.replace(", rwr-r-", "").replace(", -w-w--", "");
    let imported = import(without.as_bytes(), "sdos.txt", &Choice::default()).expect("an import");
    let guessed: Vec<_> = imported.report.notes.iter().map(|note| note.what.as_str()).collect();
    assert!(guessed.contains(&"who may read and write"), "{guessed:?}");
    let refusal = import(LIST.repeat(2).as_bytes(), "sdos.txt", &Choice::default()).expect_err("two devices");
    assert_eq!(refusal.place, Some((LIST.lines().count() + 1, 1)));
    let odd = format!("{LIST}something else\n");
    let report = import(odd.as_bytes(), "sdos.txt", &Choice::default()).expect("an import").report;
    assert_eq!(report.notes.iter().filter(|note| note.says == "something else").count(), 1);
}
