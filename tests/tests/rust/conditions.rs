//! What is assumed of the conditions of a transition is told where Rust has them.

use std::fs;
use std::path::Path;

use syn::visit_mut::VisitMut;
use toml::{Table, Value};

/// A shipped output.
pub(crate) fn generated(device: &str, kind: &str) -> String {
    let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated").join(device);
    fs::read_to_string(place.join(format!("{device}.{kind}"))).expect("it is shipped")
}

/// The documentation of an item as one line.
pub(crate) fn documentation(attributes: &[syn::Attribute]) -> String {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(syn::MetaNameValue {
            path,
            value: syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }),
            ..
        }) if path.is_ident("doc") => Some(text.value().trim().to_owned()),
        _ => None,
    });
    lines.collect::<Vec<_>>().join(" ")
}

/// The documentation of the constants of conditions.
#[derive(Default)]
struct Conditions(String);

impl VisitMut for Conditions {
    fn visit_item_const_mut(&mut self, item: &mut syn::ItemConst) {
        if item.ident == "CONDITIONS" {
            self.0 += &documentation(&item.attrs);
        }
    }
}

/// The tables of the transitions that a folder describes.
fn transitions(device: &str) -> Vec<(String, Value)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(device);
    let files = fs::read_dir(folder).expect("it is shipped").map(|file| file.expect("a file").path());
    let described =
        files.filter(|file| file.extension().is_some_and(|kind| kind == "toml")).flat_map(|file| {
            let text = fs::read_to_string(file).expect("a text");
            let table: Table = text.parse().expect("TOML");
            let transitions = table.get("transitions").and_then(Value::as_table).cloned();
            transitions.into_iter().flatten().collect::<Vec<_>>()
        });
    described.collect()
}

#[test]
fn each_reason_for_an_assumed_condition_stands_at_the_conditions() {
    let mut told = Vec::new();
    for device in ["c887", "pmc-sc6", "s700"] {
        let mut conditions = Conditions::default();
        conditions.visit_file_mut(&mut syn::parse_file(&generated(device, "rs")).expect("Rust"));
        for (number, transition) in transitions(device) {
            let reasons = ["events", "interlocks"].into_iter().filter_map(|key| {
                let assumed = transition.get("assumed").filter(|_| transition.get(key).is_some())?;
                assumed.as_str().or_else(|| assumed.get(key)?.as_str())
            });
            for reason in reasons {
                let said = conditions.0.replace('\\', "");
                let at = said
                    .split(&format!("*{number}*: "))
                    .nth(1)
                    .unwrap_or_else(|| panic!("{device} {number}: {said}"));
                assert!(at.contains(reason), "{device} {number}: {said}");
                told.push((device, number.clone()));
            }
        }
    }
    assert!(told.contains(&("pmc-sc6", "9".into())), "{told:?}");
}
