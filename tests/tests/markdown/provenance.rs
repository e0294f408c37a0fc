//! What no source states is marked where it stands, and what nobody said is not there.

use crate::described;

/// The line of a table about something.
fn row<'t>(reference: &'t str, about: &str) -> &'t str {
    reference
        .lines()
        .find(|line| line.starts_with('|') && line.contains(about))
        .unwrap_or_else(|| panic!("{reference}"))
}

#[test]
fn an_entry_with_a_reason_of_its_own_keeps_those_of_its_object() {
    for (of_object, of_entry) in [
        ("assumed = { access = \"by trial\" }", "assumed = { min = \"by hearsay\" }"),
        ("assumed = \"by trial\"", "assumed = { min = \"by hearsay\" }"),
    ] {
        let text = described(&format!(
            "[objects.0x2000]\nname = \"Gains\"\nkind = \"array\"\ntype = \"INT16\"\naccess = \"rw\"\n{of_object}\n\
             [objects.0x2000.entries]\n1 = {{ name = \"First\", min = 3, {of_entry} }}\n2 = {{ name = \"Second\" }}\n"
        ));
        assert!(row(&text, "First").contains("rw<sup>[‡]"), "{}", row(&text, "First"));
        assert!(row(&text, "Second").contains("rw<sup>[‡]"), "{}", row(&text, "Second"));
    }
    let text = described(
        "[objects.0x2000]\nname = \"Gains\"\nkind = \"array\"\ntype = \"INT16\"\naccess = \"rw\"\n\
         assumed = { access = \"by trial\" }\n[objects.0x2000.entries]\n1 = { name = \"First\", access = \"ro\" }\n",
    );
    assert!(row(&text, "First").contains("ro |"), "{}", row(&text, "First"));
}

#[test]
fn what_a_drive_does_with_a_wrong_command_stands_there_if_it_is_said() {
    let sentence = "A command that leads nowhere";
    let states = "[states.on]\nname = \"On\"\npattern = \"x000 0001\"\n";
    let control = |keys: &str| described(&format!("[device-control]\nsource = \"1\"\n{keys}\n{states}"));
    assert!(!control("modes-selectable-in = []").contains(sentence));
    assert!(control("wrong-command = \"ignored\"").contains("is ignored.\n"));
    let assumed = control("wrong-command = \"ignored\"\nassumed = { wrong-command = \"by trial\" }");
    assert!(assumed.contains("is ignored.<sup>[‡]"), "{assumed}");
}
