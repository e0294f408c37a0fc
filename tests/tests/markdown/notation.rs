//! Values stand in the reference as the description has them: in hexadecimal what is written so, and in decimal the rest.

use std::fs;

use toml::{Table, Value};

use crate::{described, folders, references};

/// The keys of all tables of values with what they mean, within a section.
fn values<'v>(of: &'v Value, found: &mut Vec<(&'v str, &'v str)>) {
    let Some(table) = of.as_table() else { return };
    for (key, value) in table {
        match (key.as_str(), value.as_table()) {
            ("values", Some(values)) => found.extend(values.iter().filter_map(|(number, meaning)| {
                Some((number.as_str(), meaning.as_str().or_else(|| meaning.get("name")?.as_str())?))
            })),
            _ => values_of_lists(value, found),
        }
    }
}

fn values_of_lists<'v>(value: &'v Value, found: &mut Vec<(&'v str, &'v str)>) {
    values(value, found);
    value.as_array().into_iter().flatten().for_each(|one| values(one, found));
}

/// A key as it is shown.
fn shown(key: &str) -> String {
    let number = |number: &str| match number.strip_prefix("0x") {
        Some(digits) => format!("`0x{}`", digits.to_uppercase()),
        None => format!("`{number}`"),
    };
    key.split("..=").map(|part| number(part.trim())).collect::<Vec<_>>().join(" to ")
}

#[test]
fn values_keep_the_notation_of_their_keys() {
    let mut hexadecimal = 0;
    for ((family, reference), folder) in references().iter().zip(folders()) {
        let reference = reference.replace('\\', "");
        for file in fs::read_dir(folder).expect("a folder").map(|file| file.expect("a file").path()) {
            let Ok(table) = fs::read_to_string(&file).unwrap_or_default().parse::<Table>() else { continue };
            let mut found = Vec::new();
            for section in ["telegrams", "registers", "parameters", "words"] {
                table.get(section).into_iter().for_each(|section| values(section, &mut found));
            }
            for (key, name) in found {
                let said = format!("{} {name}", shown(key));
                assert!(reference.contains(&said), "{}: {said}", family.id);
                hexadecimal += usize::from(key.starts_with("0x"));
            }
        }
    }
    // the commands of the mailbox of the S700 alone are eleven
    assert!(hexadecimal > 11, "{hexadecimal}");
}

#[test]
fn an_object_shows_its_values_as_they_are_written() {
    let text = described(
        "[objects.0x2000]\nname = \"Request\"\ntype = \"UINT16\"\naccess = \"rw\"\n\
         values = { 0x0b = \"hexadecimal\", 0x001C = \"with zeros\", 17 = \"decimal\" }\n",
    );
    for row in ["| `0x0B` | hexadecimal |", "| `0x001C` | with zeros |", "| `17` | decimal |"] {
        assert!(text.contains(row), "{row}: {text}");
    }
}
