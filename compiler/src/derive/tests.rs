//! The derive without a compiler around it.

use std::path::Path;

use proc_macro2::TokenStream;

use super::{expand, module_name, own_pdo, process_image};
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
    expand(tokens(input), Path::new("/user"), &files).to_string()
}

fn tokens(code: &str) -> TokenStream {
    code.parse().expect("tokens")
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
        ("#[device] pub struct Drive;", "#[device(...)]"),
        ("#[device = \"a\"] pub struct Drive;", "#[device(...)]"),
        ("#[device(path)] pub struct Drive;", "expected `path = ..`"),
        ("#[device(path = )] pub struct Drive;", "expected an expression"),
        ("#[device(\"a\")] pub struct Drive;", "no setting `\\\"a\\\"`"),
        ("#[device(path \"a\")] pub struct Drive;", "expected a comma"),
        ("#[device(pth)] pub struct Drive;", "no setting `pth`"),
        ("#[device(path = 5)] pub struct Drive;", "a plain text"),
        ("#[device(path = b\"a\")] pub struct Drive;", "a plain text"),
        ("#[device(path = concat!(\"a\"))] pub struct Drive;", "a plain text"),
        ("#[device(path = \"a\", path = \"b\")] pub struct Drive;", "set twice"),
        ("#[device(pth = \"a\")] pub struct Drive;", "no setting `pth`"),
        ("#[device(path = \"a\" module = \"b\")] pub struct Drive;", "expected a comma"),
        ("#[device(path = \"a\", module = \"1\")] pub struct Drive;", "no name of a module"),
        ("#[device(path = \"a\", module = type)] pub struct Drive;", "no name of a module"),
        ("#[device(path = \"a\", runtime = a<u8>)] pub struct Drive;", "no path of a crate"),
        ("#[device(path = \"a\", runtime = \"a b\")] pub struct Drive;", "no path of a crate"),
        ("#[device(path = \"a\")] struct Drive;", "has to be `pub struct Drive;`"),
        ("#[device(path = \"a\")] pub(crate) struct Drive;", "has to be `pub struct Drive;`"),
        ("#[device(path = \"a\")] pub struct Drive(u8);", "unit struct"),
        ("#[device(path = \"a\")] pub enum Drive {}", "unit struct"),
        ("#[device(path = \"a\")] pub union Drive { a: u8 }", "unit struct"),
        ("#[device(path = \"a\")] pub struct Drive<const N: u8>;", "cannot have generics"),
        ("#[device(path = \"a\")]", "cannot read this"),
        ("", "cannot read this"),
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
fn all_errors_are_told_at_once() {
    let inputs = [
        ("#[device(pth = 1, 2, module =)] struct Drive<T>(T);", 6),
        ("#[device(path = 1, member, module = \"1\", runtime = 2)] pub struct Drive;", 4),
    ];
    for (input, count) in inputs {
        let code = expanded(input, DEVICE);
        assert_eq!(code.matches("compile_error").count(), count, "{input}: {code}");
    }
    let image = "struct Outputs<T> { #[image(axis)] a: [T; 0], #[image(axes = 1)] b: T }";
    let mapping = "struct Setpoints<T> { #[pdo(gap = 0)] a: T, #[pdo(A, B, gap)] b: T }";
    let mapping = format!("#[pdo(per_axis = 1, gap = 256, runtime = 5)] {mapping}");
    for (code, count) in [(process_image(tokens(image)), 4), (own_pdo(tokens(&mapping)), 7)] {
        assert_eq!(code.to_string().matches("compile_error").count(), count, "{code}");
    }
}

#[test]
fn names_may_be_raw_identifiers() {
    let code = expanded("#[device(path = \"devices/drive\")] pub struct r#Drive;", DEVICE);
    assert!(code.contains("pub mod drive {"), "{code}");
    let code = expanded("#[device(path = \"devices/drive\", module = r#type)] pub struct Drive;", DEVICE);
    assert!(code.contains("pub mod r#type {"), "{code}");
    let code = own_pdo(tokens("#[pdo(mapping = m::Free)] struct r#Match { r#type: u8 }")).to_string();
    assert!(code.contains("(m :: objects :: TYPE)"), "{code}");
    assert!(code.contains("MatchView of r#Match") && code.contains("r#type , set_type :"), "{code}");
}

/// Without its feature `full` syn reads less of Rust than there is; whether it has that depends on what else is built.
#[test]
fn what_syn_does_not_read_is_left_to_rustc() {
    let branch = "if a { 1 } else { 2 }";
    let image =
        format!("struct Outputs {{ #[image(axis = {branch})] a: A, #[image(axis = [1, 2][0],)] b: B }}");
    let code = process_image(tokens(&image)).to_string();
    assert!(code.contains(&format!("(({branch}) as u8)")) && code.contains("([1 , 2] [0])"), "{code}");
    let mapping =
        format!("#[pdo(mapping = Free::<1, 2>)] struct Setpoints {{ #[pdo({branch}, gap = 8)] a: A }}");
    let code = own_pdo(tokens(&mapping)).to_string();
    assert!(code.contains(&format!("mapped :: < Free :: < 1 , 2 > , A , _ , _ > ({branch})")), "{code}");
    let is_full = syn::parse_str::<syn::Expr>(branch).is_ok();
    let array = format!("#[pdo(mapping = Free)] struct Setpoints {{ a: [u8; {branch}] }}");
    assert_eq!(own_pdo(tokens(&array)).to_string().contains("cannot read this"), !is_full);
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
