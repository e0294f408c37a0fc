//! What each part of a description counts, as the message about too many entries tells it: a range for all of its
//! subindices, a KiB of text for another entry, what each axis has for each axis.

use std::path::Path;

use super::{Axes, Room, parts};
use crate::diagnostic::Diagnostics;
use crate::profiles;
use crate::raw::{self, RawDevice};
use crate::source::{Memory, Sources, load};

const HEAD: &str =
    "[device]\nname = \"X\"\nvendor = \"V\"\n[identity]\nvendor-id = 1\nproduct-code = 2\nrevision = 3\n";

/// Two axes, of which each has what is from 0x2000 to 0x27FF.
const AXES: &str = "[axes]\nnames = [\"X\", \"Y\"]\nshifts = [{ range = \"0x2000..=0x27FF\", by = 0x800 }]\npdo-shift = 0x10\n";

fn device(text: &str) -> RawDevice {
    let loader = Memory::new().with("x/device.toml", [HEAD, text].concat());
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let document = load(&loader, Path::new("x"), profiles::ALL, &mut sources, &mut diagnostics);
    let document = document.expect("a document");
    let reading = raw::read(&document, "x", &sources, &mut diagnostics).into_iter().next();
    let said: Vec<_> = diagnostics.iter().map(|it| &it.message).collect();
    assert!(said.is_empty(), "{text}: {said:?}");
    reading.expect("a device").printed
}

/// How many entries a description counts.
fn count(text: &str) -> usize {
    let raw = device(text);
    parts(&raw, &Axes::new(raw.axes.as_ref())).map(|(count, _)| count).sum()
}

#[test]
fn each_part_counts_what_is_made_of_it() {
    let long = "x".repeat(2_500);
    for (text, expected) in [
        ("", 0),
        // an object, and its entries
        ("[objects.0x2000]\nname = \"A\"\ntype = \"UINT8\"\n", 1),
        ("[objects.0x2000]\nname = \"A\"\nkind = \"array\"\nentries.0x01.type = \"UINT8\"\n", 2),
        ("[objects.0x2000]\nname = \"A\"\nkind = \"array\"\nentries.\"0x01..=0xFE\".type = \"UINT8\"\n", 255),
        // a PDO: what it maps, and what excludes it
        (
            "[rx-pdos.0x1600]\nname = \"P\"\nentries = [\"0x6040\", \"0x6041\", { bits = 8 }]\nexcludes = [\"0x1601\"]\n",
            4,
        ),
        ("[tx-pdos.0x1A00]\nname = \"P\"\nentries = [\"0x6041\"]\n", 1),
        // a configuration: what it assigns and maps
        (
            "[configurations.a]\nname = \"A\"\noutputs = [\"0x1600\", \"0x1601\"]\ninputs = [\"0x1A00\"]\n\
             mapping.\"0x1600\" = [\"0x6040\", \"0x6042\", \"0x6043\"]\n",
            6,
        ),
        // a unit is one, however many axes there are
        ("[units.u]\nquantity = \"time\"\nsymbol = \"s\"\n", 0),
    ] {
        assert_eq!(count(text), expected, "{text}");
    }
    let described = format!("[objects.0x2000]\nname = \"A\"\ntype = \"UINT8\"\nabout = \"{long}\"\n");
    assert_eq!(count(&described), 3, "an object, and two KiB that are full");
    let entries = format!(
        "[objects.0x2000]\nname = \"A\"\nkind = \"array\"\n[objects.0x2000.entries.\"0x01..=0x0A\"]\ntype = \"UINT8\"\nabout = \"{long}\"\n"
    );
    assert_eq!(count(&entries), 1 + 2 + 10 * (1 + 2), "the text is the object's, and that of each entry");
    let pdo = format!("[rx-pdos.0x1600]\nname = \"P\"\nentries = [\"0x6040\"]\nabout = \"{long}\"\n");
    assert_eq!(count(&pdo), 1 + 2);
}

#[test]
fn what_an_axis_has_counts_for_each() {
    for (text, expected) in [
        // what is from 0x2000 to 0x27FF, and what is not
        ("[objects.0x2000]\nname = \"A\"\ntype = \"UINT8\"\n", 2),
        ("[objects.0x27FF]\nname = \"A\"\ntype = \"UINT8\"\n", 2),
        ("[objects.0x3000]\nname = \"A\"\ntype = \"UINT8\"\n", 1),
        // of two versions of an object the larger one counts
        (
            "[objects.0x2000]\nname = \"A\"\nkind = \"array\"\nentries.0x01.type = \"UINT8\"\n\
             [objects.0x2000.per-axis.Y]\nentries.0x02.type = \"UINT8\"\n",
            2 * 3,
        ),
        // a PDO that each axis has, and one that all share; configurations are the axes' if a PDO is
        ("[rx-pdos.0x1600]\nname = \"P\"\nper-axis = true\nentries = [\"0x6040\", \"0x6041\"]\n", 4),
        ("[rx-pdos.0x1600]\nname = \"P\"\nentries = [\"0x6040\", \"0x6041\"]\n", 2),
        (
            "[rx-pdos.0x1600]\nname = \"P\"\nper-axis = true\nentries = [\"0x6040\"]\n\
             [configurations.a]\nname = \"A\"\noutputs = [\"0x1600\"]\ninputs = [\"0x1A00\", \"0x1A01\"]\n",
            2 + 2 * 3,
        ),
        (
            "[rx-pdos.0x1600]\nname = \"P\"\nentries = [\"0x6040\"]\n\
             [configurations.a]\nname = \"A\"\noutputs = [\"0x1600\"]\ninputs = [\"0x1A00\", \"0x1A01\"]\n",
            1 + 3,
        ),
        // what is there once reaches the objects of each axis, what an axis has those of its own
        (
            "[objects.0x3000]\nname = \"A\"\ntype = \"UINT8\"\n\
             trigger = { value = 1, action = \"x\", uses = [\"0x2000\"], updates = [\"0x2001\", \"0x2002\"] }\n",
            1 + 3,
        ),
        (
            "[objects.0x2000]\nname = \"A\"\ntype = \"UINT8\"\n\
             trigger = { value = 1, action = \"x\", updates = [\"0x2001\", \"0x2002\"] }\n",
            2,
        ),
        // a unit that differs is made for each
        (
            "[units.u]\nquantity = \"time\"\nsymbol = \"s\"\n[units.u.per-axis.Y]\nsymbol = \"ms\"\n\
             [units.v]\nquantity = \"time\"\nsymbol = \"s\"\n",
            2,
        ),
    ] {
        assert_eq!(count(&[AXES, text].concat()), expected, "{text}");
    }
    let long = "x".repeat(2_500);
    let unit = format!(
        "{AXES}[units.u]\nquantity = \"time\"\nsymbol = \"s\"\nabout = \"{long}\"\n[units.u.per-axis.Y]\nsymbol = \"ms\"\n"
    );
    assert_eq!(count(&unit), 2 * (1 + 2));
}

#[test]
fn what_is_left_is_just_enough_or_too_little() {
    let raw = device(
        "[objects.0x2000]\nname = \"A\"\nkind = \"array\"\nentries.\"0x01..=0x09\".type = \"UINT8\"\n",
    );
    let take = |mut room: Room, times: usize| {
        let mut diagnostics = Diagnostics::default();
        let taken = (0..times).all(|_| room.take(&raw, &mut diagnostics));
        assert_eq!(taken, !diagnostics.has_errors());
        taken
    };
    assert!(take(Room(10), 1));
    assert!(!take(Room(9), 1));
    assert!(take(Room(30), 3), "each device of a family takes its own");
    assert!(!take(Room(29), 3));
    assert!(take(Room::new(), 20_000));
    assert!(!take(Room::new(), 20_001));
}

/// What each axis counts is told only where there are several.
#[test]
fn the_message_says_what_axes_have_to_do_with_it() {
    let object = "[objects.0x2000]\nname = \"A\"\ntype = \"UINT8\"\n";
    let one = "[axes]\nnames = [\"X\"]\n";
    for (axes, notes) in [("", 1), (one, 1), (AXES, 2)] {
        let mut diagnostics = Diagnostics::default();
        assert!(!Room(0).take(&device(&[axes, object].concat()), &mut diagnostics));
        let said = diagnostics.iter().next().expect("a message");
        assert_eq!(said.notes.len(), notes, "{axes}: {:?}", said.notes);
    }
}
