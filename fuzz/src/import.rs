//! Files of ESI become descriptions.

use std::sync::LazyLock;

use bolero::TypeGenerator;
use devc::emit::{self, Options};
use devc::import::{Choice, Imported, Refusal, import};

use crate::run::holds;
use crate::subjects::{ALL, SHIPPED, compile};
use crate::xml::{Edit, edited, encoded};

/// A file that somebody broke.
#[derive(Debug, TypeGenerator)]
struct Input {
    file: u8,
    encoding: u8,
    device: u8,
    edits: Vec<Edit>,
}

/// A file as a vendor makes it, and what devc makes of descriptions that are not too long.
static FILES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let drive = include_str!("../../tests/tests/import/files/drive.xml").to_owned();
    let families = ALL.iter().skip(SHIPPED).filter_map(|files| compile(files).family);
    let made = families.filter_map(|family| {
        let files = emit::emit(&family, &[&emit::esi::Esi], &Options::default());
        files.text(".xml").filter(|text| (8_000..40_000).contains(&text.len())).map(str::to_owned)
    });
    std::iter::once(drive).chain(made.take(6)).collect()
});

#[test]
fn files() {
    holds("files", 30, |input: &Input| {
        let text = edited(&FILES[usize::from(input.file) % FILES.len()], &input.edits);
        let device = Some(input.device % 4).filter(|number| *number > 0).map(|number| number.to_string());
        match import(&encoded(&text, input.encoding), "drive.xml", &Choice { device, revision: None }) {
            Ok(imported) => is_whole(&imported),
            Err(refusal) => is_told(&refusal, &text),
        }
    });
}

/// What comes out compiles, whatever it was made of, and so does what is imported of the ESI that is made of it.
fn is_whole(imported: &Imported) {
    let again = made(imported);
    let choice = Choice { device: Some("1".to_owned()), revision: None };
    let again = import(again.as_bytes(), "drive.xml", &choice);
    made(&again.unwrap_or_else(|refusal| panic!("{refusal:?} of what devc made")));
}

/// The ESI of an import.
fn made(imported: &Imported) -> String {
    let compilation = devc::compile(&imported.in_memory("device"), "device".as_ref());
    let messages: Vec<&String> = compilation.diagnostics.iter().map(|it| &it.message).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{messages:?} of {:#?}", imported.files));
    let files = emit::emit(&family, &[&emit::esi::Esi], &Options::default());
    files.text(".xml").expect("an ESI").to_owned()
}

/// A refusal says why, and where in the file.
fn is_told(refusal: &Refusal, text: &str) {
    assert!(!refusal.why.is_empty());
    let lines = text.lines().count() + 1;
    let is_inside = |(line, column): (usize, usize)| (1..=lines).contains(&line) && column > 0;
    assert!(refusal.place.is_none_or(is_inside), "{refusal:?}");
}
