//! The description of the S300, S400, S600 and S700 against the tables of their manual, fact by fact.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

#[path = "../described/mod.rs"]
mod described;
mod dictionary;
mod front;
mod mailbox;
mod process_data;
mod registers;
mod startup;
mod states;
mod timing;
mod words;

use std::sync::LazyLock;

use devc::lint::Checked;
use devc::model::{Device, Family};
use devc_tests::manual::{Member, s700};

use described::{departs, plain, rows};

/// The family as `devices/s700` describes it.
fn family() -> &'static Family {
    static FAMILY: LazyLock<Checked<Family>> = LazyLock::new(|| described::family("s700"));
    &FAMILY
}

/// All members, in the order of the manual.
const MEMBERS: [Member; 4] = [Member::S300, Member::S400, Member::S600, Member::S700];

/// A member.
fn device(member: Member) -> &'static Device {
    let id = match member {
        Member::S300 => "s300",
        Member::S400 => "s400",
        Member::S600 => "s600",
        Member::S700 => "s700",
    };
    family().members.iter().find(|device| device.id == id).unwrap_or_else(|| panic!("there is no {id}"))
}

/// Whether a row that names `members` holds for `member`; none stands for all.
fn holds_for(members: &[Member], member: Member) -> bool {
    members.is_empty() || members.contains(&member)
}

/// A fact that stands in no table.
fn fact(key: &str) -> &'static str {
    let facts = rows::<s700::Fact>();
    facts.iter().find(|fact| fact.key == key).unwrap_or_else(|| panic!("there is no fact {key}")).value
}

/// A fact that is a number, decimal or hexadecimal.
fn number(key: &str) -> u32 {
    let text = fact(key);
    text.strip_prefix("0x")
        .map_or_else(|| text.parse(), |digits| u32::from_str_radix(digits, 16))
        .unwrap_or_else(|_| panic!("{key}: `{text}` is no number"))
}

#[test]
fn members_are_those_of_the_manual() {
    let named: Vec<&str> = family().members.iter().map(|device| device.name.as_str()).collect();
    assert_eq!(named.join(", "), fact("models"));
    for device in &family().members {
        let title = device.title.as_deref().expect("each has a title");
        assert_eq!(title.contains("expansion card"), fact("option-card").contains(&device.name), "{title}");
        assert_eq!(title.contains("on board"), fact("built-in").contains(&device.name), "{title}");
    }
}
