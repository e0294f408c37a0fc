//! Coordinates of parameters, and the parameters themselves, against chapters 4.2 and 7.2.

use devc::model::{Coordinates, Group, Kind};
use devc_tests::manual::pmc_sc6;

use crate::{departs, device, fact, family, number, rows};

fn coordinates() -> &'static Coordinates {
    device().coordinates.as_ref().expect("they are described")
}

/// The coordinates of a member: the template that it is described with decides on subindices.
fn member_coordinates(id: &str) -> &'static Coordinates {
    let member = family().members.iter().find(|member| member.id == id).expect("there is one");
    member.coordinates.as_ref().expect("they are described")
}

fn group(letter: &str) -> &'static Group {
    let found = coordinates().groups.iter().find(|group| group.letter == letter);
    found.unwrap_or_else(|| panic!("there is no group {letter}"))
}

/// The distance from axis A to an axis.
fn shift(axis: devc_tests::manual::AxisLetter) -> u16 {
    let area = device()
        .arrangement
        .shifts
        .iter()
        .find(|shift| shift.first.0 == 0x2000)
        .expect("parameters are shifted");
    area.by * u16::from(number(axis))
}

#[test]
fn the_examples_come_out() {
    for row in rows::<pmc_sc6::Coordinate>() {
        assert_eq!(coordinates().base.0 + shift(row.axis), row.base);
        assert_eq!(coordinates().group_size, row.factor);
        assert_eq!(group(&row.parameter[..1]).number, Some(row.group));
        for (member, subindex) in [("double", row.sdo_info), ("double-hires", row.rx)] {
            let coordinates = member_coordinates(member);
            let address = coordinates.address(row.parameter).expect("its line has an index");
            assert_eq!(
                (address.index.0 + shift(row.axis), address.subindex),
                (row.index, subindex),
                "{member}"
            );
        }
    }
    let simple = coordinates().address("A67").map(|address| address.subindex.to_string());
    assert_eq!(simple.as_deref(), Some(fact("parameter-subindex-simple")));
}

#[test]
fn groups_are_those_of_both_axes() {
    let mut other = Vec::new();
    for row in rows::<pmc_sc6::Group>() {
        let group = group(row.letter);
        assert_eq!(group.number, Some(row.number), "{}", row.letter);
        let own = group.per_axis.iter().find(|own| own.axis == number(row.axis));
        let shifted = group.range.map(|(first, last)| (first.0 + shift(row.axis), last.0 + shift(row.axis)));
        let range = own.map(|own| (own.first.0, own.last.0)).or(shifted);
        assert_eq!(range, Some((row.first, row.last)), "{} on axis {:?}", row.letter, row.axis);
        if own.is_some() {
            other.push((row.axis, row.letter));
        }
    }
    let known = [((devc_tests::manual::AxisLetter::B, "Z"), "a misprint: axis A and the formula give D200")];
    departs(other, known);
}

#[test]
fn groups_follow_the_formula() {
    let other = rows::<pmc_sc6::Group>().into_iter().filter(|row| {
        let first = coordinates().address(row.lowest).map(|address| address.index.0 + shift(row.axis));
        let last = coordinates().address(row.highest).map(|address| address.index.0 + shift(row.axis));
        (first, last) != (Some(row.first), Some(row.last))
    });
    let known = [
        ((37, "M"), "the range is that of number 11, but M is the 13th letter"),
        ((39, "M"), "as on axis A"),
        ((39, "Z"), "the range is that of number 24, but Z is the 26th letter"),
    ];
    departs(other.map(|row| (row.table, row.letter)), known);
}

#[test]
fn groups_are_those_of_table_1() {
    let printed: Vec<_> = rows::<pmc_sc6::GroupTopic>().iter().map(|row| row.letter).collect();
    let described: Vec<_> = coordinates().groups.iter().map(|group| group.letter.as_str()).collect();
    assert_eq!(described, printed);
    for row in rows::<pmc_sc6::GroupTopic>() {
        let name = row.topic.split(" (").next().unwrap_or_default();
        let name = name.replace("Technology – Part", "Technology, part");
        let name = name
            .strip_suffix(
                " for the drive controller, motor, brakes, motor adapter, gear unit and geared motor",
            )
            .unwrap_or(&name);
        assert_eq!(group(row.letter).name, name);
        let indexed = rows::<pmc_sc6::Group>().iter().any(|other| other.letter == row.letter);
        assert_eq!(group(row.letter).number.is_some(), indexed, "{}", row.letter);
    }
}

#[test]
fn lines_beyond_the_group_have_no_index() {
    for (coordinate, index) in [("A511", Some(0x21FF)), ("A512", None), ("A925", None), ("I805", None)] {
        assert_eq!(coordinates().address(coordinate).map(|address| address.index.0), index, "{coordinate}");
    }
}

/// Whether an object has this coordinate.
fn is_object(coordinate: &str) -> bool {
    device().objects.iter().any(|object| {
        let mut entries = object.entries.iter().map(|entry| entry.parameter.as_deref());
        object.parameter.as_deref() == Some(coordinate) || entries.any(|it| it == Some(coordinate))
    })
}

#[test]
fn parameters_are_those_of_the_text() {
    let parameters = &device().parameters;
    let rows = rows::<pmc_sc6::Parameter>();
    let missing = rows.iter().filter(|row| {
        !is_object(row.parameter) && parameters.iter().all(|parameter| parameter.id != row.parameter)
    });
    departs(missing.map(|row| row.parameter), []);
    let other = parameters.iter().filter(|parameter| rows.iter().all(|row| row.parameter != parameter.id));
    departs(other.map(|parameter| parameter.id.as_str()), []);
}

#[test]
fn parameters_have_their_names_or_say_that_none_is_printed() {
    for row in rows::<pmc_sc6::Parameter>() {
        let Some(parameter) = device().parameters.iter().find(|it| it.id == row.parameter) else { continue };
        let at = format!("parameters.{}.name", row.parameter);
        let assumed = device().assumptions.iter().any(|assumption| assumption.at.to_string() == at);
        assert_eq!(assumed, row.name.is_empty(), "{}: {:?}", row.parameter, row.name);
        assert!(
            assumed || parameter.name == row.name,
            "{}: {}, printed {}",
            row.parameter,
            parameter.name,
            row.name
        );
    }
}

#[test]
fn parameters_lie_where_the_formula_puts_them() {
    for parameter in &device().parameters {
        let element = if parameter.has_elements() { "[0]" } else { "" };
        let place = coordinates().address(&format!("{}{element}", parameter.id));
        assert_eq!(parameter.address, place, "{}", parameter.id);
    }
}

#[test]
fn parameters_are_what_the_text_says_they_are() {
    let made_of = |id: &str| {
        let found = device().parameters.iter().find(|parameter| parameter.id == id);
        found.map(|parameter| (parameter.kind, parameter.elements))
    };
    // Table 3: start, progress and result of saving; an access level for each way in; a single value.
    assert_eq!(made_of("A00"), Some((Some(Kind::Record), Some(3))));
    assert_eq!(made_of("A10"), Some((Some(Kind::Array), None)));
    assert_eq!(made_of("A21"), Some((Some(Kind::Var), None)));
    // 6.1.4: sixteen sources.
    assert_eq!(made_of("A66"), Some((None, Some(16))));
}
