//! Texts in other languages, and the messages of the diagnosis history.

use crate::subjects::corners;

/// The numbers of languages are those of Windows: 1031 is German, 1036 French, 2052 Chinese.
#[test]
fn texts_are_there_in_all_languages() {
    let device = &corners().esi.devices[0];
    let count = |tag: &str, language: u16, text: &str| {
        let is_it = |it: &&(String, u16, String)| it.0 == tag && it.1 == language && it.2 == text;
        device.translations.iter().filter(is_it).count()
    };
    assert_eq!((count("Name", 1031, "Ecke"), count("Name", 2052, "角")), (1, 1));
    assert_eq!(device.url.as_deref(), Some("https://example.com/a?b&c"));
    assert_eq!(count("URL", 1031, "https://example.com/ä"), 1);
    assert_eq!(count("Text", 1036, "Allumé"), 1);
    assert_eq!(count("Name", 1031, "Diagnose"), 1);
    // Both axes have the PDO and the object; what the PDO carries is called as the object's entry.
    assert_eq!((count("Name", 1031, "Ausgänge (left)"), count("Name", 1031, "Ausgänge (right)")), (1, 1));
    assert_eq!(count("DisplayName", 1031, "Erster"), 1);
    assert_eq!(count("Name", 1031, "Erster (left)"), 2);
}

#[test]
fn messages_are_named_by_their_text_ids() {
    let device = &corners().esi.devices[0];
    let [ready, hot] = device.messages.as_slice() else { panic!("{:?}", device.messages) };
    assert_eq!(ready, &(1, "Ready".to_owned(), None, None, None));
    let text = |text: &str| Some(text.to_owned());
    let expected = (
        0x8001,
        "Axis %d is <hot>".to_owned(),
        text("warning"),
        text("The motor warms up."),
        text("Move less."),
    );
    assert_eq!(hot, &expected);
    assert!(device.translations.contains(&(
        "MessageText".to_owned(),
        1031,
        "Achse %d ist <warm>".to_owned()
    )));
}

#[test]
fn which_commands_a_master_uses_and_where_it_finds_the_number_that_people_set() {
    let device = &corners().esi.devices[0];
    assert_eq!(device.no_lrw, Some(1));
    assert_eq!(device.set_number, (Some(0x12), Some("true".to_owned())));
}

#[test]
fn the_current_from_the_e_bus_is_in_milliamperes() {
    assert_eq!(corners().esi.devices[0].ebus_current, Some(-2000));
}
