//! The derive without a compiler around it.

use std::path::Path;

use proc_macro2::TokenStream;

use super::{expand, module_name};
use crate::source::Memory;

const DEVICE: &str = r#"
[device]
name = "Drive"
vendor = "Somebody"
title = "A drive"

[identity]
vendor-id = 1
product-code = 2
revision = 3
"#;

fn expanded(input: &str, description: &str) -> String {
    let files = Memory::new().with("/user/devices/drive/device.toml", description);
    let input: TokenStream = input.parse().expect("tokens");
    expand(input, Path::new("/user"), &files).to_string()
}

#[test]
fn a_description_becomes_a_module_and_is_tracked() {
    let code = expanded("#[device(path = \"devices/drive\")] pub struct Drive;", DEVICE);
    assert!(code.contains("impl :: devc_runtime :: Device for Drive"), "{code}");
    assert!(code.contains("pub mod drive {"), "{code}");
    assert!(code.contains("include_bytes ! (\"/user/devices/drive/device.toml\")"), "{code}");
    assert!(!code.contains("compile_error"), "{code}");
}

#[test]
fn runtime_and_module_can_be_named() {
    let input =
        "#[device(path = \"devices/drive\", runtime = \"crate::rt\", module = \"it\")] pub struct Drive;";
    let code = expanded(input, DEVICE);
    assert!(code.contains("impl crate :: rt :: Device for Drive"), "{code}");
    assert!(code.contains("pub mod it {"), "{code}");
    assert!(!code.contains("devc_runtime"), "{code}");
}

#[test]
fn errors_of_the_description_are_errors_of_the_code() {
    let code =
        expanded("#[device(path = \"devices/drive\")] pub struct Drive;", &DEVICE.replace("title", "titel"));
    assert_eq!(code.matches("compile_error").count(), 1, "{code}");
    assert!(code.contains("[unknown-key]") && code.contains("devices/drive/device.toml:5"), "{code}");
    assert!(code.contains("Device for Drive") && code.contains("include_bytes"), "{code}");
    assert!(!code.contains("/user/devices/drive/device.toml:"), "{code}");
}

#[test]
fn what_cannot_be_read_is_answered_with_an_error() {
    let inputs = [
        ("pub struct Drive;", "which device is `Drive`?"),
        ("#[device] pub struct Drive;", "expected `device(..)`"),
        ("#[device(path)] pub struct Drive;", "a plain text"),
        ("#[device(\"a\")] pub struct Drive;", "expected a setting"),
        ("#[device(path \"a\")] pub struct Drive;", "expected `=` or a comma"),
        ("#[device(pth)] pub struct Drive;", "no setting `pth`"),
        ("#[device(path = 5)] pub struct Drive;", "a plain text"),
        ("#[device(path = \"a\\n\")] pub struct Drive;", "a plain text"),
        ("#[device(path = \"a\", path = \"b\")] pub struct Drive;", "set twice"),
        ("#[device(pth = \"a\")] pub struct Drive;", "no setting `pth`"),
        ("#[device(path = \"a\" module = \"b\")] pub struct Drive;", "expected a comma"),
        ("#[device(path = \"a\", module = \"1\")] pub struct Drive;", "no name of a module"),
        ("#[device(path = \"a\", runtime = \"a b\")] pub struct Drive;", "no path of a crate"),
        ("#[device(path = \"a\")] struct Drive;", "has to be `pub struct Drive;`"),
        ("#[device(path = \"a\")] pub(crate) struct Drive;", "has to be `pub struct Drive;`"),
        ("#[device(path = \"a\")] pub struct Drive(u8);", "unit struct"),
        ("#[device(path = \"a\")] pub enum Drive {}", "unit struct"),
        ("#[device(path = \"a\")]", "unit struct"),
        ("", "unit struct"),
        ("#[device(path = \"a\")] pub struct Drive;", "[missing-file]"),
        ("#[device(path = \"devices/drive\", member = \"x\")] pub struct Drive;", "no member `x`"),
    ];
    for (input, message) in inputs {
        let code = expanded(input, DEVICE);
        assert_eq!(code.matches("compile_error").count(), 1, "{input}: {code}");
        assert!(code.contains(message), "{input}: {code}");
    }
}

#[test]
fn modules_are_named_after_structs() {
    for (name, module) in
        [("C887", "c887"), ("HexapodController", "hexapod_controller"), ("S700Drive", "s700_drive")]
    {
        let name = proc_macro2::Ident::new(name, proc_macro2::Span::call_site());
        assert_eq!(module_name(&name).to_string(), module);
    }
}
