//! Tables of every shape, and what is said about the bad ones.

use std::collections::BTreeMap;

use insta::assert_snapshot;
use serde::Deserialize;

use super::*;
use crate::diagnostic::render::{Style, text};
use crate::raw::Literal;
use crate::source::{SourceFile, Sources, parse};

#[derive(Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
struct Part {
    name: String,
    max_value: Option<u8>,
    #[serde(default)]
    scale: f64,
    #[serde(default)]
    flag: bool,
    #[serde(default)]
    codes: Vec<u16>,
    offset: Option<i8>,
    access: Option<Access>,
    shape: Option<Shape>,
    pair: Option<(u8, String)>,
    id: Option<Id>,
    literal: Option<Literal>,
    version: Option<Version>,
    #[serde(default)]
    inner: BTreeMap<String, Inner>,
    #[serde(default)]
    list: Vec<Inner>,
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Access {
    ReadOnly,
    ReadWrite,
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Shape {
    Point,
    Circle(u8),
    Square { side: u8 },
}

#[derive(Debug, PartialEq, Deserialize)]
struct Id(u32);

#[derive(Debug, Default, PartialEq, Deserialize)]
struct Inner {
    bits: u8,
    about: Option<String>,
}

/// Major and minor, written as `"1.2"`.
#[derive(Debug, PartialEq, Deserialize)]
#[serde(try_from = "String")]
struct Version(u8, u8);

impl TryFrom<String> for Version {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let parse =
            |text: &str| text.split_once('.').and_then(|(a, b)| Some(Self(a.parse().ok()?, b.parse().ok()?)));
        parse(&text).ok_or_else(|| format!("`{text}` is not a version, as `1.2` is"))
    }
}

#[derive(Debug, Default, PartialEq, Deserialize)]
struct Other {
    source: Option<String>,
}

fn tree(toml: &str) -> (Sources, Table) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let file = SourceFile { path: "device.toml".to_owned(), text: toml.to_owned(), embedded: false };
    let file = sources.add(file);
    let table = parse(file, toml, &mut diagnostics);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    (sources, table)
}

fn read<T: for<'t> Deserialize<'t>>(toml: &str) -> (Option<T>, String) {
    let (sources, table) = tree(toml);
    let mut diagnostics = Diagnostics::default();
    let mut reader = Reader::new(&table, &mut diagnostics);
    let value = reader.part();
    reader.finish();
    let messages: Vec<String> = diagnostics.iter().map(|it| text(it, &sources, Style::Plain)).collect();
    (value, messages.join("\n\n"))
}

fn good(toml: &str) -> Part {
    let (value, messages) = read(&format!("name = \"x\"\n{toml}"));
    assert_eq!(messages, "");
    value.expect("a value")
}

/// The messages on a part with a name.
fn bad(toml: &str) -> String {
    let (value, messages) = read::<Part>(&format!("name = \"x\"\n{toml}"));
    assert_eq!(value, None);
    messages
}

fn named() -> Part {
    Part { name: "x".to_owned(), ..Part::default() }
}

#[test]
fn every_shape_of_value() {
    assert_eq!(good("max-value = 255"), Part { max_value: Some(255), ..named() });
    assert_eq!(good("offset = -128"), Part { offset: Some(-128), ..named() });
    assert_eq!(good("codes = [0xFFFF, 0b1]"), Part { codes: vec![0xFFFF, 1], ..named() });
    assert_eq!(good("scale = 2"), Part { scale: 2.0, ..named() });
    assert_eq!(good("scale = 2.5\nflag = true"), Part { scale: 2.5, flag: true, ..named() });
    assert_eq!(good("id = 7"), Part { id: Some(Id(7)), ..named() });
    assert_eq!(good("pair = [1, \"a\"]"), Part { pair: Some((1, "a".to_owned())), ..named() });
    assert_eq!(good("version = \"1.2\""), Part { version: Some(Version(1, 2)), ..named() });
}

#[test]
fn every_shape_of_choice() {
    assert_eq!(good("access = \"read-only\"").access, Some(Access::ReadOnly));
    assert_eq!(good("shape = \"point\"").shape, Some(Shape::Point));
    assert_eq!(good("shape = { circle = 3 }").shape, Some(Shape::Circle(3)));
    assert_eq!(good("shape.square.side = 4").shape, Some(Shape::Square { side: 4 }));
    let literals = ["true", "-5", "0xFFFF_FFFF_FFFF_FFFF", "1.5", "\"a\""];
    let literals = literals.map(|value| good(&format!("literal = {value}")).literal.expect("a literal"));
    let expected = [
        Literal::Boolean(true),
        Literal::Integer(-5),
        Literal::Integer(u64::MAX.into()),
        Literal::Float(1.5),
        Literal::Text("a".to_owned()),
    ];
    assert_eq!(literals, expected);
}

#[test]
fn tables_in_tables() {
    let part = good("[inner.a]\nbits = 1\n[inner.b]\nbits = 2\n[[list]]\nbits = 3\n");
    assert_eq!(part.inner.values().map(|inner| inner.bits).collect::<Vec<_>>(), [1, 2]);
    assert_eq!(part.list.iter().map(|inner| inner.bits).collect::<Vec<_>>(), [3]);
}

#[test]
fn strings_are_borrowed() {
    #[derive(Deserialize)]
    struct Borrowed<'t> {
        name: &'t str,
    }
    let (_, table) = tree("name = \"x\"");
    let mut diagnostics = Diagnostics::default();
    let part: Option<Borrowed<'_>> = Reader::new(&table, &mut diagnostics).part();
    assert_eq!(part.map(|part| part.name), Some("x"));
}

#[test]
fn values_of_the_wrong_type() {
    assert_snapshot!(bad("max-value = \"5\""), @r#"
    error[wrong-type]: expected an integer for `max-value`, found a string
     --> device.toml:2:13
      |
    2 | max-value = "5"
      |             ^^^ expected an integer
    "#);
    assert_snapshot!(bad("codes = [1, [2]]"), @r"
    error[wrong-type]: expected an integer for `codes`, found an array
     --> device.toml:2:13
      |
    2 | codes = [1, [2]]
      |             ^^^ expected an integer
    ");
    assert_snapshot!(bad("flag = 1"), @r"
    error[wrong-type]: expected a boolean for `flag`, found an integer
     --> device.toml:2:8
      |
    2 | flag = 1
      |        ^ expected a boolean
    ");
    assert_snapshot!(bad("scale = 2001-01-01"), @r"
    error[wrong-type]: expected a number for `scale`, found a date
     --> device.toml:2:9
      |
    2 | scale = 2001-01-01
      |         ^^^^^^^^^^ expected a number
    ");
    assert_snapshot!(bad("inner = []"), @r"
    error[wrong-type]: expected a table for `inner`, found an array
     --> device.toml:2:9
      |
    2 | inner = []
      |         ^^ expected a table
    ");
    assert_snapshot!(bad("list = [{ bits = 1 }, [1, \"a\"]]"), @r#"
    error[wrong-type]: expected a table for `list`, found an array
     --> device.toml:2:23
      |
    2 | list = [{ bits = 1 }, [1, "a"]]
      |                       ^^^^^^^^ expected a table
    "#);
    assert_snapshot!(bad("literal = {}"), @r"
    error[wrong-type]: expected a number, a string or a boolean for `literal`, found a table
     --> device.toml:2:11
      |
    2 | literal = {}
      |           ^^ expected a number, a string or a boolean
    ");
    assert_snapshot!(bad("access = 1"), @r"
    error[wrong-type]: expected a string for `access`, found an integer
     --> device.toml:2:10
      |
    2 | access = 1
      |          ^ expected a string
    ");
    assert_snapshot!(bad("name2 = 1\npair = 1"), @r"
    error[unknown-key]: unknown key `name2`
     --> device.toml:2:1
      |
    2 | name2 = 1
      | ^^^^^ not a key of this table
      |
      = note: its keys are `name`, `max-value`, `scale`, `flag`, `codes`, `offset`, `access`, `shape`, `pair`, `id`, `literal`, `version`, `inner` and `list`

    error[wrong-type]: expected an array of 2 elements for `pair`, found an integer
     --> device.toml:3:8
      |
    3 | pair = 1
      |        ^ expected an array of 2 elements
    ");
}

#[test]
fn values_out_of_range() {
    assert_snapshot!(bad("max-value = 300"), @r"
    error[invalid-value]: 300 does not fit u8, 0 to 255
     --> device.toml:2:13
      |
    2 | max-value = 300
      |             ^^^ out of range for `max-value`
    ");
    assert_snapshot!(bad("offset = -129"), @r"
    error[invalid-value]: -129 does not fit i8, -128 to 127
     --> device.toml:2:10
      |
    2 | offset = -129
      |          ^^^^ out of range for `offset`
    ");
    assert_snapshot!(bad("list = [{ bits = 1 }, { bits = 0xFFFF_FFFF_FFFF_FFFF_FFFF }]"), @r"
    error[invalid-value]: 1208925819614629174706175 does not fit u8, 0 to 255
     --> device.toml:2:32
      |
    2 | list = [{ bits = 1 }, { bits = 0xFFFF_FFFF_FFFF_FFFF_FFFF }]
      |                                ^^^^^^^^^^^^^^^^^^^^^^^^^^ out of range for `bits`
    ");
    assert_snapshot!(bad("pair = [1, \"a\", 2]"), @r#"
    error[invalid-value]: expected 2 elements, found 3
     --> device.toml:2:17
      |
    2 | pair = [1, "a", 2]
      |                 ^
    "#);
    assert_snapshot!(bad("pair = [1]"), @r"
    error[invalid-value]: expected an array of 2 elements, found 1 elements
     --> device.toml:2:8
      |
    2 | pair = [1]
      |        ^^^
    ");
}

#[test]
fn values_that_mean_nothing() {
    assert_snapshot!(bad("access = \"readonly\""), @r#"
    error[invalid-value]: `readonly` is not a value of `access`
     --> device.toml:2:10
      |
    2 | access = "readonly"
      |          ^^^^^^^^^^ not known here
      |
      = note: the values are `read-only` and `read-write`
    help: did you mean `read-only`?
      |
    2 | access = "read-only"
      |               +
    "#);
    assert_snapshot!(bad("access = \"x\""), @r#"
    error[invalid-value]: `x` is not a value of `access`
     --> device.toml:2:10
      |
    2 | access = "x"
      |          ^^^ not known here
      |
      = note: the values are `read-only` and `read-write`
    "#);
    assert_snapshot!(bad("version = \"1\""), @r#"
    error[invalid-value]: `1` is not a version, as `1.2` is
     --> device.toml:1:1
      |
    1 | / name = "x"
    2 | | version = "1"
      | |_____________^
    "#);
    assert_snapshot!(bad("shape = \"circle\""), @r#"
    error[invalid-value]: this needs a value, as in `{ word = value }`
     --> device.toml:2:9
      |
    2 | shape = "circle"
      |         ^^^^^^^^
    "#);
    assert_snapshot!(bad("shape = { circel = 1 }"), @r"
    error[invalid-value]: `circel` is not a value of `shape`
     --> device.toml:2:11
      |
    2 | shape = { circel = 1 }
      |           ^^^^^^ not known here
      |
      = note: the values are `point`, `circle` and `square`
    help: did you mean `circle`?
      |
    2 - shape = { circel = 1 }
    2 + shape = { circle = 1 }
      |
    ");
    assert_snapshot!(bad("shape = { point = 1 }"), @r"
    error[invalid-value]: this takes no value
     --> device.toml:2:19
      |
    2 | shape = { point = 1 }
      |                   ^
    ");
    assert_snapshot!(bad("shape = { circle = 1, square = {} }"), @r"
    error[invalid-value]: expected a table with one key, found 2
     --> device.toml:2:23
      |
    2 | shape = { circle = 1, square = {} }
      |                       ^^^^^^
    ");
    assert_snapshot!(bad("shape = {}"), @r"
    error[invalid-value]: expected a table with one key, found none
     --> device.toml:2:9
      |
    2 | shape = {}
      |         ^^
    ");
}

#[test]
fn every_unknown_key_is_reported() {
    let (part, messages) = read::<Part>(
        "name = \"x\"\nmaxvalue = 1\nwidth = 2\n[inner.a]\nbits = 1\nabuot = \"\"\n[[list]]\nbits = 1\nz = 1",
    );
    assert!(part.is_some());
    assert_snapshot!(messages, @r#"
    error[unknown-key]: unknown key `abuot`
     --> device.toml:6:1
      |
    6 | abuot = ""
      | ^^^^^ not a key of this table
      |
    help: did you mean `about`?
      |
    6 - abuot = ""
    6 + about = ""
      |

    error[unknown-key]: unknown key `z`
     --> device.toml:9:1
      |
    9 | z = 1
      | ^ not a key of this table
      |
      = note: its keys are `bits` and `about`

    error[unknown-key]: unknown key `maxvalue`
     --> device.toml:2:1
      |
    2 | maxvalue = 1
      | ^^^^^^^^ not a key of this table
      |
    help: did you mean `max-value`?
      |
    2 | max-value = 1
      |    +

    error[unknown-key]: unknown key `width`
     --> device.toml:3:1
      |
    3 | width = 2
      | ^^^^^ not a key of this table
      |
      = note: its keys are `name`, `max-value`, `scale`, `flag`, `codes`, `offset`, `access`, `shape`, `pair`, `id`, `literal`, `version`, `inner` and `list`
    "#);
}

#[test]
fn a_missing_key() {
    assert_snapshot!(read::<Part>("scale = 1").1, @r"
    error[missing-key]: missing key `name`
     --> device.toml:1:1
      |
    1 | scale = 1
      | ^^^^^^^^^ `name` has to be given here
    ");
    assert_snapshot!(bad("list = [{ about = \"\" }]"), @r#"
    error[missing-key]: missing key `bits`
     --> device.toml:2:9
      |
    2 | list = [{ about = "" }]
      |         ^^^^^^^^^^^^^^ `bits` has to be given here
    "#);
}

#[test]
fn a_misspelled_key_is_not_missing_too() {
    assert_snapshot!(read::<Part>("nmae = \"x\"").1, @r#"
    error[unknown-key]: unknown key `nmae`
     --> device.toml:1:1
      |
    1 | nmae = "x"
      | ^^^^ not a key of this table
      |
    help: did you mean `name`?
      |
    1 - nmae = "x"
    1 + name = "x"
      |
    "#);
    assert_snapshot!(bad("list = [{ bit = 1 }]"), @r"
    error[unknown-key]: unknown key `bit`
     --> device.toml:2:11
      |
    2 | list = [{ bit = 1 }]
      |           ^^^ not a key of this table
      |
    help: did you mean `bits`?
      |
    2 | list = [{ bits = 1 }]
      |              +
    ");
}

#[test]
fn one_table_can_be_two_structs() {
    let (sources, table) = tree("bits = 1\nsource = \"p. 1\"\nsuorce = 2\n");
    let mut diagnostics = Diagnostics::default();
    let mut reader = Reader::new(&table, &mut diagnostics);
    let parts = (reader.part::<Inner>(), reader.part::<Other>());
    reader.finish();
    assert_eq!(parts.0.map(|inner| inner.bits), Some(1));
    assert_eq!(parts.1.and_then(|other| other.source).as_deref(), Some("p. 1"));
    let messages: Vec<String> = diagnostics.iter().map(|it| text(it, &sources, Style::Plain)).collect();
    assert_snapshot!(messages.join("\n\n"), @r"
    error[unknown-key]: unknown key `suorce`
     --> device.toml:3:1
      |
    3 | suorce = 2
      | ^^^^^^ not a key of this table
      |
      = note: its keys are `bits`, `about` and `source`
    ");
}
