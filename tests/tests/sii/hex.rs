//! The files: which devices have them, and that Intel hex holds the same bytes.

use std::process::Command;

use devc::emit::sii::Sii;
use devc::emit::{Emitter, Files, Options};

use crate::like_esi::{SHIPPED, family};
use crate::reader::{Image, intel_hex};

fn files(id: &str) -> Files {
    Sii.emit(&family(id), &Options::default())
}

#[test]
fn a_device_has_an_image_where_its_first_bytes_are_known() {
    let names = SHIPPED.iter().flat_map(|id| files(id).0.into_keys());
    let known =
        ["s300", "s400", "s600", "s700"].iter().flat_map(|id| [format!("{id}.bin"), format!("{id}.hex")]);
    assert_eq!(names.collect::<Vec<_>>(), known.collect::<Vec<_>>());
}

#[test]
fn intel_hex_holds_the_bytes_of_the_image() {
    let files = files("s700").0;
    for (name, bytes) in files.iter().filter(|(name, _)| name.ends_with(".bin")) {
        assert_eq!(bytes.len(), 2048);
        assert_eq!(Image::read(bytes).words[0], 9, "the first byte is the description's");
        let hex = std::str::from_utf8(&files[&name.replace(".bin", ".hex")]).unwrap();
        assert_eq!(intel_hex(hex), *bytes, "{name}");
        assert!(hex.ends_with(":00000001FF\n"), "the end as the format has it");
    }
}

/// More than 64 KiB need records for the upper half of the address.
#[test]
fn a_large_image_is_read_by_objcopy() {
    let family = crate::corners::compiled(&include_str!("corner.toml").replace("4096", "131072"));
    let files = Sii.emit(&family, &Options::default());
    let (bytes, hex) = (&files.0["corner.bin"], &files.0["corner.hex"]);
    assert_eq!((bytes.len(), &intel_hex(std::str::from_utf8(hex).unwrap())), (131_072, bytes));
    let folder = tempfile::tempdir().unwrap();
    let [from, to] = ["a.hex", "a.bin"].map(|name| folder.path().join(name));
    std::fs::write(&from, hex).unwrap();
    match Command::new("objcopy").args(["-I", "ihex", "-O", "binary"]).args([&from, &to]).status() {
        Ok(status) => {
            assert!(status.success());
            assert_eq!(&std::fs::read(&to).unwrap(), bytes);
        }
        Err(error) => eprintln!("objcopy is not asked: {error}"),
    }
}
