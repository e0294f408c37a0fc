//! The log for code scanning, against the schema of SARIF 2.1.0 as OASIS publishes it, less its texts.

#![cfg(test)]

use std::path::Path;

use devc::diagnostic::{Diagnostics, Rule, faults, render};
use devc::lint;
use devc::source::{Disk, Sources};
use jsonschema::Validator;
use serde_json::Value;

fn validator() -> Validator {
    let schema: Value = serde_json::from_str(include_str!("schema.json")).expect("it is JSON");
    jsonschema::options().should_validate_formats(true).build(&schema).expect("it is a schema")
}

fn rules() -> Vec<&'static Rule> {
    faults::ALL.iter().copied().chain(lint::ALL.iter().map(|lint| lint.rule)).collect()
}

/// The log about a folder, as a reader gets it.
fn log(folder: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    let compilation = devc::compile(&Disk, &folder);
    let runs: [(&Diagnostics, &Sources); 1] = [(&compilation.diagnostics, &compilation.sources)];
    serde_json::from_str(&render::sarif(&runs, &rules())).expect("a log is JSON")
}

fn assert_valid(validator: &Validator, log: &Value) {
    let errors: Vec<String> =
        validator.iter_errors(log).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{errors:#?}");
}

#[test]
fn every_log_fits_the_schema() {
    let validator = validator();
    // A hundred faults with labels, notes and fixes; syntax errors; faults of the format; none at all.
    let hundred = log("compiler/tests/hundred");
    assert!(hundred["runs"][0]["results"].as_array().is_some_and(|results| results.len() >= 100));
    for log in [
        hundred,
        log("tests/cases/several-syntax-errors"),
        log("tests/cases/unknown-keys"),
        log("devices/s700"),
    ] {
        assert_valid(&validator, &log);
    }
}

#[test]
fn no_files_make_a_log_too() {
    let log = serde_json::from_str(&render::sarif(&[], &rules())).expect("a log is JSON");
    assert_valid(&validator(), &log);
}

/// What makes the test above worth something.
#[test]
fn the_schema_refuses_what_is_not_sarif() {
    let validator = validator();
    let good = log("compiler/tests/hundred");
    let broken: [fn(&mut Value); 5] = [
        |log| log["version"] = "2.0.0".into(),
        |log| log["runs"][0]["results"][0]["level"] = "severe".into(),
        |log| {
            log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0.into()
        },
        |log| log["runs"][0]["results"][0]["message"] = "text".into(),
        |log| log["runs"][0]["tool"]["driver"]["colour"] = "red".into(),
    ];
    for spoil in broken {
        let mut log = good.clone();
        spoil(&mut log);
        assert!(!validator.is_valid(&log));
    }
}
