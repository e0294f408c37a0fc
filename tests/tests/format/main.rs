//! The format: its schema and its reference are those of the structs that read it, and what is shipped keeps to it.

#![cfg(test)]

mod text;

use std::fs;
use std::path::{Path, PathBuf};

use devc::raw::schema::{reference, schema};
use jsonschema::Validator;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Compares a checked-in file with what devc makes; `DEVC_BLESS=1` writes it.
fn is_current(path: &str, made: &str) {
    let path = root().join(path);
    if std::env::var_os("DEVC_BLESS").is_some() {
        fs::write(&path, made).expect("the file can be written");
    }
    let checked_in = fs::read_to_string(&path).unwrap_or_default();
    assert!(checked_in == made, "{} is out of date: run the tests with DEVC_BLESS=1", path.display());
}

#[test]
fn the_schema_is_current() {
    is_current("compiler/schema/device.schema.json", &schema());
}

#[test]
fn the_reference_is_current() {
    is_current("compiler/docs/format.md", &reference());
}

fn validator() -> Validator {
    let schema: Value = serde_json::from_str(&schema()).expect("the schema is JSON");
    jsonschema::validator_for(&schema).expect("the schema is one")
}

/// What the schema has against a file of a description.
fn faults(validator: &Validator, text: &str) -> Vec<String> {
    let value: Value = toml::from_str(text).expect("the file is TOML");
    validator.iter_errors(&value).map(|fault| format!("{}: {fault}", fault.instance_path())).collect()
}

/// Every file of every description that is shipped, and the profiles.
fn files() -> Vec<PathBuf> {
    let entries = |folder: PathBuf| {
        let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        entries.map(|entry| entry.expect("it can be read").path()).collect::<Vec<_>>()
    };
    let mut files: Vec<PathBuf> = entries(root().join("devices")).into_iter().flat_map(entries).collect();
    files.extend(entries(root().join("compiler/profiles")));
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    files
}

#[test]
fn all_that_is_shipped_fits_the_schema() {
    let validator = validator();
    let files = files();
    assert!(files.len() > 20, "{files:?}");
    for file in files {
        let text = fs::read_to_string(&file).expect("it can be read");
        let faults = faults(&validator, &text);
        assert!(faults.is_empty(), "{}: {faults:#?}", file.display());
    }
}

#[test]
fn what_is_wrong_does_not_fit_the_schema() {
    let validator = validator();
    let broken = [
        ("[devise]\nname = \"x\"\n", "a section that there is not"),
        ("[device]\nnaem = \"x\"\n", "a key that there is not"),
        ("[identity]\nvendor-id = \"x\"\n", "a text for a number"),
        ("[objects.0x6040]\naccess = \"rx\"\n", "a word that is none of those to choose from"),
        ("[objects.0x6040.entries.1]\ntyp = \"UINT8\"\n", "a key of an entry"),
        ("[words.controlword]\nbits.0 = 3\n", "a number for a name"),
        ("[cycle-times.x]\nname = \"x\"\nmin = \"1 week\"\n", "a time without a known unit"),
        ("[members.x.objects.0x6040]\nnmae = \"x\"\n", "a key in a member"),
        ("[lints]\nx = \"loud\"\n", "a level that there is not"),
    ];
    for (text, what) in broken {
        assert!(!faults(&validator, text).is_empty(), "{what}: {text}");
    }
}

/// The reference has a heading for whatever it refers to.
#[test]
fn every_link_of_the_reference_leads_somewhere() {
    let text = reference();
    for link in text.split("](#").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(text.contains(&format!("<a id=\"{link}\"></a>")), "nothing at #{link}");
    }
}
