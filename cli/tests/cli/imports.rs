//! `devc import`: files, messages and exit codes.

use super::Desk;

/// An ESI file of two devices that have little in common, one of them in two revisions.
fn esi() -> String {
    let device = |name: &str, code: u32, revision: u32| {
        format!(
            "<Device Physics=\"YY\"><Type ProductCode=\"{code}\" RevisionNo=\"{revision}\">{name}</Type>\
             <Name>{name}</Name><GroupType>G</GroupType>\n<Comment>old stock</Comment></Device>"
        )
    };
    format!(
        "<EtherCATInfo><Vendor><Id>#x76D</Id><Name>Example</Name></Vendor><Descriptions><Devices>{}{}{}</Devices>\
         </Descriptions></EtherCATInfo>",
        device("Drive 1", 1, 1),
        device("Drive 1", 1, 2),
        device("Valve", 2, 1)
    )
}

fn desk() -> Desk {
    let desk = Desk::new(&[]);
    desk.put("drive.xml", esi());
    desk
}

#[test]
fn an_import_is_a_description_that_devc_checks_and_builds() {
    let desk = desk();
    let run = desk.devc(&["import", "drive.xml", "--device", "Drive 1"]);
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert_eq!(desk.list("devices/drive-1"), ["device.toml"]);
    assert!(desk.read("devices/drive-1/device.toml").contains("revision     = 0x00000002"));
    assert!(run.err.contains("lost: Device/Comment, `old stock`, at 3:1"), "{}", run.err);
    assert_eq!(desk.devc(&["check", "devices/drive-1"]).code, Some(0));
    assert_eq!(desk.devc(&["build", "devices/drive-1"]).code, Some(0));
}

#[test]
fn what_to_choose_from_is_listed() {
    let run = desk().devc(&["import", "drive.xml"]);
    assert_eq!(run.code, Some(2));
    for choice in ["1: Drive 1, product 0x00000001, revision 0x00000001", "2: Drive 1", "3: Valve"] {
        assert!(run.err.contains(choice), "{}", run.err);
    }
}

#[test]
fn the_report_is_there_for_tools() {
    let desk = desk();
    let run = desk.devc(&["import", "drive.xml", "--device", "3", "--out", "valve", "--report", "loss.json"]);
    assert_eq!(run.code, Some(0), "{}", run.err);
    let report: serde_json::Value = serde_json::from_str(&desk.read("loss.json")).expect("JSON");
    assert_eq!((&report["facts"], &report["lost"]), (&7.into(), &1.into()));
    assert_eq!((&report["notes"][0]["kind"], &report["notes"][0]["line"]), (&"lost".into(), &4.into()));
}

#[test]
fn files_that_are_there_stay_unless_the_user_says_otherwise() {
    let desk = desk();
    desk.put("mine/device.toml", "# mine\n");
    let import = ["import", "drive.xml", "--device", "Valve", "--out", "mine"];
    let run = desk.devc(&import);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("is there already") && run.err.contains("--overwrite"), "{}", run.err);
    assert_eq!(desk.read("mine/device.toml"), "# mine\n");
    assert_eq!(desk.devc(&[&import[..], &["--overwrite"]].concat()).code, Some(0));
    assert!(desk.read("mine/device.toml").contains("Valve"));
    assert_eq!(desk.list("mine"), ["device.toml"]);
}

#[test]
fn files_of_an_earlier_import_go_with_it() {
    let desk = desk();
    let earlier = "# Imported from old.xml; from now on this is the source.\n";
    desk.put("mine/device.toml", earlier);
    desk.put("mine/objects.toml", "# The dictionary.\n\nsource = \"old.xml\"\n\n[objects]\n");
    // Of another file, and somebody's own.
    desk.put("mine/pdos.toml", "# Process data.\n\nsource = \"other.xml\"\n");
    desk.put("mine/diagnosis.toml", "# mine\n");
    let run = desk.devc(&["import", "drive.xml", "--device", "Valve", "--out", "mine", "--overwrite"]);
    assert_eq!(run.code, Some(0), "{}", run.err);
    assert!(run.out.contains("objects.toml: removed"), "{}", run.out);
    assert_eq!(desk.list("mine"), ["device.toml", "diagnosis.toml", "pdos.toml"]);
    // Where no import made the description, nothing goes.
    desk.put("own/device.toml", "# mine\n");
    desk.put("own/objects.toml", "# The dictionary.\n\nsource = \"old.xml\"\n");
    desk.devc(&["import", "drive.xml", "--device", "Valve", "--out", "own", "--overwrite"]);
    assert_eq!(desk.list("own"), ["device.toml", "objects.toml"]);
}

#[test]
fn what_cannot_be_imported_is_said_with_its_place() {
    let desk = desk();
    desk.put("page.xml", "\n<html/>");
    let run = desk.devc(&["import", "page.xml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("`page.xml:2:1`: it is no ESI file: its root is `html`"), "{}", run.err);
    assert_eq!(desk.devc(&["import", "none.xml"]).code, Some(2));
    assert!(desk.list("devices").is_empty());
}
