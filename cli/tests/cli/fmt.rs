//! `devc fmt` writes files as `check --fix` does, and leaves alone what is not TOML.

use crate::{Desk, SOUND};

/// A description whose keys stand in another order and not below each other.
fn untidy() -> String {
    SOUND
        .replace("name   = \"Example\"\nvendor = \"Example\"", "vendor = \"Example\" # who\nname=\"Example\"")
        + "\n[areas.\"0x2000..=0x20ff\"]\nname = 'A'\n"
}

fn tidy() -> String {
    let codes =
        SOUND.replace("= 0x76D", "= 0x0000076D").replace("product-code = 3", "product-code = 0x00000003");
    codes.trim_start().to_owned()
}

#[test]
fn files_are_laid_out_once() {
    let desk = Desk::new(&[("a", &untidy()), ("b", tidy().as_str())]);
    desk.devc(&["fmt", "--check"]).ends(1, &["`devices/a/device.toml` is not laid out, from line 1 on"]);
    assert_eq!(desk.read("devices/a/device.toml"), untidy());
    let run = desk.devc(&["fmt"]);
    run.ends(0, &["devices/a/device.toml: laid out"]);
    assert!(!run.out.contains("devices/b"), "{}", run.out);
    let text = desk.read("devices/a/device.toml");
    assert!(
        text.starts_with("[device]\nname   = \"Example\"\nvendor = \"Example\" # who\n\n[identity]"),
        "{text}"
    );
    assert!(text.contains("[areas.\"0x2000..=0x20FF\"]\nname = 'A'\n\n[objects.0x2000]"), "{text}");
    let run = desk.devc(&["fmt"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (Some(0), "", ""));
    desk.devc(&["fmt", "--check"]).ends(0, &[]);
}

#[test]
fn a_folder_is_all_files_of_the_description_and_a_file_is_one() {
    let desk = Desk::new(&[]);
    desk.put("drive/device.toml", "include = [\"more.toml\"]\n[device]\nname=\"A\"\n");
    desk.put("drive/more.toml", "[units.a]\nsymbol=\"m\"\n");
    desk.put("drive/other.toml", "[units.b]\nsymbol=\"m\"\n");
    desk.devc(&["fmt", "drive/device.toml"]).ends(0, &["drive/device.toml: laid out"]);
    assert_eq!(desk.read("drive/more.toml"), "[units.a]\nsymbol=\"m\"\n");
    desk.devc(&["fmt", "drive"]).ends(0, &["drive/more.toml: laid out"]);
    assert_eq!(desk.read("drive/more.toml"), "[units.a]\nsymbol = \"m\"\n");
    assert_eq!(desk.read("drive/other.toml"), "[units.b]\nsymbol=\"m\"\n");
}

#[test]
fn what_is_not_toml_is_left_alone() {
    let desk = Desk::new(&[("a", "[device\nname=1\n"), ("b", &untidy())]);
    desk.devc(&["fmt"])
        .ends(1, &["invalid-toml", "devices/a/device.toml:1", "devices/b/device.toml: laid out"]);
    assert_eq!(desk.read("devices/a/device.toml"), "[device\nname=1\n");
    desk.devc(&["fmt", "nowhere"]).ends(2, &["`nowhere` does not exist"]);
}

#[cfg(unix)]
#[test]
fn rights_are_kept_and_other_names_refused() {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    let desk = Desk::new(&[("a", &untidy())]);
    let path = desk.path("devices/a/device.toml");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("a mode");
    fs::hard_link(&path, desk.path("other.toml")).expect("a link");
    desk.devc(&["fmt"]).ends(2, &["it has another name, by a hard link"]);
    assert_eq!(desk.read("devices/a/device.toml"), untidy());
    fs::remove_file(desk.path("other.toml")).expect("a file");
    desk.devc(&["fmt"]).ends(0, &["laid out"]);
    let mode = fs::metadata(&path).expect("a file").permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}
