//! Mailbox telegrams against chapter 3.13, and its example read by the description.

use std::collections::BTreeMap;

use devc::model::{Field, Telegram};
use devc_generated::s700::s700::dictionary::Dictionary;
use devc_runtime::coe::{Envelope, Mailbox, Request, Service};
use devc_runtime::object::Address;
use devc_runtime::sdo::{CommunicationState, Server};
use devc_tests::manual::s700;

use crate::{departs, family, number, rows};

/// `output` and `input` are seen from the master.
fn telegram(mailbox: &str) -> &'static Telegram {
    let id = match mailbox {
        "output" | "request" => "mailbox-out",
        _ => "mailbox-in",
    };
    family().members[0].telegrams.iter().find(|telegram| telegram.id == id).expect("it is described")
}

fn field(mailbox: &str, byte: u8) -> &'static Field {
    let found = telegram(mailbox).fields.iter().find(|field| (field.low..=field.high).contains(&byte));
    found.unwrap_or_else(|| panic!("{mailbox} lacks byte {byte}"))
}

/// How the description names what the manual calls so; a few share a byte.
fn named(printed: &str) -> &'static str {
    match printed {
        name if name.starts_with("Length") => "length",
        name if name.starts_with("Address") => "address",
        "Channel" | "Priority" => "channel, priority",
        "Type" => "type",
        "PDO Number" => "PDO number",
        "MSB of the PDO number" | "CoE specific type" => "service",
        "Control-Byte in the CAN telegram" => "command",
        name if name.contains("object number") => "index",
        "Subindex" => "subindex",
        name if name.starts_with("Data") => "data",
        other => panic!("{other} is a new name"),
    }
}

#[test]
fn bytes_are_those_of_the_figures() {
    for row in rows::<s700::TelegramField>() {
        let field = field(row.mailbox, row.byte);
        if row.name == "Reserved" {
            assert!(field.about.as_deref().is_some_and(|about| about.contains("reserved")), "{row:?}");
        } else {
            assert_eq!(field.name, named(row.name), "{row:?}");
        }
        let end = number("mailbox-telegram-bytes");
        let last = telegram(row.mailbox).fields.iter().map(|field| u32::from(field.high)).max();
        assert_eq!(last, Some(end - 1));
    }
}

#[test]
fn one_table_is_a_byte_off() {
    let other = rows::<s700::TelegramField>().into_iter().filter(|row| {
        let field = field(row.mailbox, row.printed);
        row.name != "Reserved" && field.name != named(row.name)
    });
    let why =
        "the table of the output has all from the service on a byte too early; the example has it right";
    let known = [
        (("output", 6, "MSB of the PDO number"), why),
        (("output", 6, "CoE specific type"), why),
        (("output", 7, "Control-Byte in the CAN telegram"), why),
        (("output", 8, "Low Byte of the CAN object number (Index)"), why),
        (("output", 10, "Subindex"), why),
        (("output", 11, "Data (Low Byte)"), why),
    ];
    departs(other.map(|row| (row.mailbox, row.printed, row.name)), known);
}

#[test]
fn values_are_those_of_the_tables() {
    let mut printed: BTreeMap<(&str, u8), Vec<i64>> = BTreeMap::new();
    for row in rows::<s700::TelegramValue>() {
        let values = &field(row.mailbox, row.byte).values;
        let found = values.iter().find(|value| value.value == i64::from(row.value));
        // What is reserved may be left out, or says so.
        let reserved = found.is_none_or(|value| value.name.contains("reserved"));
        assert_eq!(reserved, row.reserved, "{row:?}");
        if found.is_some() {
            printed.entry((row.mailbox, row.byte)).or_default().push(row.value.into());
        }
    }
    for ((mailbox, byte), mut values) in printed {
        values.sort_unstable();
        let described: Vec<_> = field(mailbox, byte).values.iter().map(|value| value.value).collect();
        assert_eq!(described, values, "{mailbox}, byte {byte}");
    }
}

/// What the description says of a byte of the example.
fn meaning(telegram: &str, byte: u8, value: u8) -> Option<&'static str> {
    // The service is in the upper half of its byte.
    let value = if byte == 7 { value >> 4 } else { value };
    let found = field(telegram, byte).values.iter().find(|meaning| meaning.value == i64::from(value));
    found.map(|meaning| meaning.name.as_str())
}

#[test]
fn the_example_means_what_it_says() {
    let says = [
        ("request", 5, "CAN over EtherCAT"),
        ("request", 7, "SDO request"),
        ("request", 8, "write 2 bytes"),
        ("answer", 5, "CAN over EtherCAT"),
        ("answer", 7, "SDO answer"),
        ("answer", 8, "written"),
    ];
    let rows = rows::<s700::MailboxByte>();
    let other = says.into_iter().filter(|(telegram, byte, says)| {
        let row = rows.iter().find(|row| row.telegram == *telegram && row.byte == *byte);
        row.and_then(|row| meaning(telegram, *byte, row.value)) != Some(says)
    });
    departs(other, [(("answer", 7, "SDO answer"), "0x20 is a request; an answer is 0x30")]);
}

#[test]
fn the_example_names_an_entry_and_a_mapping() {
    let rows = rows::<s700::MailboxByte>();
    let value = |telegram, name| {
        let bytes =
            rows.iter().filter(|row| row.telegram == telegram && field(telegram, row.byte).name == name);
        bytes.rev().fold(0_u32, |high, row| high << 8 | u32::from(row.value))
    };
    for telegram in ["request", "answer"] {
        assert_eq!((value(telegram, "index"), value(telegram, "subindex")), (0x1C12, 1));
    }
    let pdo = value("request", "data");
    assert!(family().members.iter().all(|member| member.pdos.iter().any(|it| u32::from(it.index.0) == pdo)));
    let lengths = [("request", 10), ("answer", 14)];
    // Six bytes of head, ten of what follows; the answer's length is remarked on.
    departs(
        lengths.into_iter().filter(|(telegram, _)| value(telegram, "length") != 16 - 6),
        [(("answer", 14), "counted from byte 2, where the request counts what follows the head")],
    );
}

/// The bytes of the example as printed.
fn printed(telegram: &str) -> Vec<u8> {
    rows::<s700::MailboxByte>().iter().filter(|row| row.telegram == telegram).map(|row| row.value).collect()
}

#[test]
fn the_example_is_what_the_codec_makes_of_it_but_for_two_errors() {
    let address = Address::new(0x1C12, 1);
    let value = 0x1704_u16.to_le_bytes();
    let asked = Request::Download { address, is_complete: false, size: Some(2), data: &value };
    let mut request = [0xAA; 16];
    assert_eq!(asked.encode(Envelope::new(Service::SDO_REQUEST), &mut request), Ok(16));
    let mut mailbox: Mailbox<Dictionary> = Mailbox::new(Server::new(Dictionary::DEFAULT, ()));
    // the chapter on fixed mappings clears the assignment before, as a server wants it
    mailbox.server.values.sync_manager_2_pdo_assignment.count = 0;
    let mut answer = [0xAA; 16];
    assert_eq!(mailbox.answer(&request, CommunicationState::PreOperational, &mut answer), 16);
    let made =
        request.iter().map(|byte| ("request", *byte)).chain(answer.iter().map(|byte| ("answer", *byte)));
    let all = ["request", "answer"].map(printed).concat();
    let other = made.zip(all).zip((0..16).cycle()).filter(|(((_, made), printed), _)| made != printed);
    departs(
        other.map(|(((telegram, made), printed), byte)| (telegram, byte, printed, made)),
        [
            (("answer", 0, 0x0E, 0x0A), "the length counts what follows the six bytes of the header"),
            (("answer", 7, 0x20, 0x30), "0x20 is a request; an answer is 0x30"),
        ],
    );
    assert_eq!(mailbox.server.values.sync_manager_2_pdo_assignment.items[0], 0x1704);
}
