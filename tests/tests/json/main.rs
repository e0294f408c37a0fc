//! The JSON model: what it says is what its schema says, and nothing of the model is missing from it.

#![cfg(test)]

use std::fs;
use std::path::{Path, PathBuf};

use devc::emit::json::{FORMAT, Json, VERSION, schema};
use devc::emit::{Emitter, Options, emit};
use devc::source::Disk;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every description that is shipped, compiled, as its JSON text.
fn outputs() -> Vec<(String, String)> {
    let folders = fs::read_dir(root().join("devices")).expect("there are descriptions");
    let mut folders: Vec<PathBuf> = folders.map(|folder| folder.expect("it can be read").path()).collect();
    folders.sort();
    let texts = folders.iter().flat_map(|folder| {
        let compilation = devc::compile(&Disk, folder);
        let family = compilation.family.unwrap_or_else(|| panic!("{} compiles", folder.display()));
        let files = emit(&family, &[&Json as &dyn Emitter], &Options::default());
        files.0.into_iter().map(|(name, content)| (name, String::from_utf8(content).expect("text")))
    });
    texts.collect()
}

fn parse(text: &str) -> Value {
    serde_json::from_str(text).expect("the output is JSON")
}

/// Regenerates the checked-in schema; `DEVC_BLESS=1` writes it.
#[test]
fn the_schema_is_current() {
    let path = root().join("compiler/schema/model.schema.json");
    let schema = schema();
    if std::env::var_os("DEVC_BLESS").is_some() {
        fs::write(&path, &schema).expect("the schema can be written");
    }
    let checked_in = fs::read_to_string(&path).unwrap_or_default();
    assert!(checked_in == schema, "{} is out of date: run the tests with DEVC_BLESS=1", path.display());
}

#[test]
fn every_output_fits_the_schema() {
    let validator = jsonschema::validator_for(&parse(&schema())).expect("the schema is one");
    let outputs = outputs();
    assert!(!outputs.is_empty());
    for (name, text) in outputs {
        let output = parse(&text);
        let faults: Vec<String> = validator.iter_errors(&output).map(|fault| fault.to_string()).collect();
        assert!(faults.is_empty(), "{name}: {faults:#?}");
        assert_eq!(output["format"], FORMAT, "{name}");
        assert_eq!(output["version"], VERSION, "{name}");
    }
}

/// A schema that lets everything pass would prove nothing above.
#[test]
fn the_schema_refuses_what_is_not_the_model() {
    let validator = jsonschema::validator_for(&parse(&schema())).expect("the schema is one");
    let (_, text) = outputs().remove(0);
    let broken = |change: fn(&mut Value)| {
        let mut output = parse(&text);
        change(&mut output);
        !validator.is_valid(&output)
    };
    assert!(broken(|output| output["version"] = 0.into()));
    assert!(broken(|output| output["members"] = Value::Null));
    assert!(broken(|output| output["members"][0]["objects"][0]["index"] = "0x1000".into()));
    assert!(broken(|output| output["members"][0]["objects"][0]["kind"] = "struct".into()));
    assert!(broken(|output| {
        output["members"][0].as_object_mut().map(|device| device.remove("identity"));
    }));
}

#[test]
fn each_list_of_the_model_is_in_the_output() {
    let family = devc::compile(&Disk, &root().join("devices/c887")).family.expect("it compiles");
    let files = Json.emit(&family, &devc::emit::Options::default());
    let output = parse(files.text(".json").expect("the model"));
    let device = family.members.first().expect("there is a device");
    let member = &output["members"][0];
    let length = |list: &str| member[list].as_array().map(Vec::len);
    assert_eq!(length("pdos"), Some(device.pdos.len()));
    assert_eq!(length("words"), Some(device.words.len()));
    assert_eq!(length("errors"), Some(device.errors.len()));
    assert_eq!(length("transitions"), Some(device.transitions.len()));
    assert_eq!(length("objects"), Some(device.objects.len()));
    for (object, shown) in device.objects.iter().zip(member["objects"].as_array().into_iter().flatten()) {
        assert_eq!(shown["index"], object.index.0);
        assert_eq!(shown["entries"].as_array().map(Vec::len), Some(object.entries.len()));
    }
}
