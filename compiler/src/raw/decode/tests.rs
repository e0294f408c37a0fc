//! Tables of every shape, and what is said about the bad ones.

use std::collections::BTreeMap;

use insta::assert_snapshot;
use serde::Deserialize;

use super::*;
use crate::diagnostic::render::{Style, text};
use crate::model::{Fields, Literal};
use crate::raw::RawMapped;
use crate::source::parse::parse;
use crate::source::{Layer, SourceFile, Sources};

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
    let table = parse(file, toml, Layer::Description, &mut diagnostics);
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
    error[wrong-type]: expected an integer, found a string
     --> device.toml:2:13
      |
    2 | max-value = "5"
      |             ^^^ in `max-value`
      |
    help: a number has no quotes
      |
    2 - max-value = "5"
    2 + max-value = 5
      |
    "#);
    assert_snapshot!(bad("codes = [1, [2]]"), @r"
    error[wrong-type]: expected an integer, found an array
     --> device.toml:2:13
      |
    2 | codes = [1, [2]]
      |             ^^^ in `codes`
    ");
    assert_snapshot!(bad("flag = 1"), @r"
    error[wrong-type]: expected a boolean, found an integer
     --> device.toml:2:8
      |
    2 | flag = 1
      |        ^ in `flag`
    ");
    assert_snapshot!(bad("scale = 2001-01-01"), @r"
    error[wrong-type]: expected a number, found a date
     --> device.toml:2:9
      |
    2 | scale = 2001-01-01
      |         ^^^^^^^^^^ in `scale`
    ");
    assert_snapshot!(bad("inner = []"), @r"
    error[wrong-type]: expected a table, found an array
     --> device.toml:2:9
      |
    2 | inner = []
      |         ^^ in `inner`
    ");
    assert_snapshot!(bad("list = [{ bits = 1 }, [1, \"a\"]]"), @r#"
    error[wrong-type]: expected a table, found an array
     --> device.toml:2:23
      |
    2 | list = [{ bits = 1 }, [1, "a"]]
      |                       ^^^^^^^^ in `list`
    "#);
    assert_snapshot!(bad("literal = {}"), @r"
    error[wrong-type]: expected a number, a string or a boolean, found a table
     --> device.toml:2:11
      |
    2 | literal = {}
      |           ^^ in `literal`
    ");
    assert_snapshot!(bad("access = 1"), @r"
    error[wrong-type]: expected a string, found an integer
     --> device.toml:2:10
      |
    2 | access = 1
      |          ^ in `access`
    ");
    assert_snapshot!(bad("name2 = 1\npair = 1"), @r"
    error[unknown-key]: unknown key `name2`
     --> device.toml:2:1
      |
    2 | name2 = 1
      | ^^^^^ not a key of this table
      |
      = note: its keys are `name`, `max-value`, `scale`, `flag`, `codes`, `offset`, `access`, `shape`, `pair`, `id`, `literal`, `version`, `inner` and `list`

    error[wrong-type]: expected an array of 2 elements, found an integer
     --> device.toml:3:8
      |
    3 | pair = 1
      |        ^ in `pair`
    ");
}

#[test]
fn values_out_of_range() {
    assert_snapshot!(bad("max-value = 300"), @r"
    error[invalid-value]: expected a number from 0 to 255, found 300
     --> device.toml:2:13
      |
    2 | max-value = 300
      |             ^^^ in `max-value`
    ");
    assert_snapshot!(bad("offset = -129"), @r"
    error[invalid-value]: expected a number from -128 to 127, found -129
     --> device.toml:2:10
      |
    2 | offset = -129
      |          ^^^^ in `offset`
    ");
    assert_snapshot!(bad("list = [{ bits = 1 }, { bits = 0xFFFF_FFFF_FFFF_FFFF_FFFF }]"), @r"
    error[invalid-value]: expected a number from 0 to 255, found 1208925819614629174706175
     --> device.toml:2:32
      |
    2 | list = [{ bits = 1 }, { bits = 0xFFFF_FFFF_FFFF_FFFF_FFFF }]
      |                                ^^^^^^^^^^^^^^^^^^^^^^^^^^ in `bits`
    ");
    assert_snapshot!(bad("pair = [1, \"a\", 2]"), @r#"
    error[invalid-value]: expected 2 elements, found 3
     --> device.toml:2:17
      |
    2 | pair = [1, "a", 2]
      |                 ^ in `pair`
    "#);
    assert_snapshot!(bad("pair = [1]"), @r"
    error[invalid-value]: expected an array of 2 elements, found 1
     --> device.toml:2:8
      |
    2 | pair = [1]
      |        ^^^ in `pair`
    ");
}

#[test]
fn values_that_mean_nothing() {
    assert_snapshot!(bad("access = \"readonly\""), @r#"
    error[invalid-value]: `readonly` is no choice here
     --> device.toml:2:10
      |
    2 | access = "readonly"
      |          ^^^^^^^^^^ in `access`
      |
      = note: the values are `read-only` and `read-write`
    help: did you mean `read-only`?
      |
    2 | access = "read-only"
      |               +
    "#);
    assert_snapshot!(bad("access = \"x\""), @r#"
    error[invalid-value]: `x` is no choice here
     --> device.toml:2:10
      |
    2 | access = "x"
      |          ^^^ in `access`
      |
      = note: the values are `read-only` and `read-write`
    "#);
    assert_snapshot!(bad("version = \"1\""), @r#"
    error[invalid-value]: `1` is not a version, as `1.2` is
     --> device.toml:2:11
      |
    2 | version = "1"
      |           ^^^ in `version`
    "#);
    assert_snapshot!(bad("shape = \"circle\""), @r#"
    error[invalid-value]: `circle` needs a value, as `{ circle = 1 }`
     --> device.toml:2:9
      |
    2 | shape = "circle"
      |         ^^^^^^^^ in `shape`
    "#);
    assert_snapshot!(bad("shape = { circel = 1 }"), @r"
    error[invalid-value]: `circel` is no choice here
     --> device.toml:2:11
      |
    2 | shape = { circel = 1 }
      |           ^^^^^^ in `shape`
      |
      = note: the values are `point`, `circle` and `square`
    help: did you mean `circle`?
      |
    2 - shape = { circel = 1 }
    2 + shape = { circle = 1 }
      |
    ");
    assert_snapshot!(bad("shape = { point = 1 }"), @r"
    error[invalid-value]: `point` takes no value, write it as a string
     --> device.toml:2:19
      |
    2 | shape = { point = 1 }
      |                   ^ in `shape`
    ");
    assert_snapshot!(bad("shape = { circle = 1, square = {} }"), @r"
    error[invalid-value]: expected a table with one key, found 2
     --> device.toml:2:23
      |
    2 | shape = { circle = 1, square = {} }
      |                       ^^^^^^ in `shape`
    ");
    assert_snapshot!(bad("shape = {}"), @r"
    error[invalid-value]: expected a table with one key, found none
     --> device.toml:2:9
      |
    2 | shape = {}
      |         ^^ in `shape`
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

#[test]
fn a_string_can_stand_for_a_table() {
    #[derive(Debug, Deserialize)]
    struct Pdo {
        entries: Vec<RawMapped>,
        #[serde(default)]
        bits: Option<Fields>,
    }
    let (pdo, messages) =
        read::<Pdo>("entries = [\"controlword\", { bits = 8, nam = \"gap\" }]\nbits = { 0 = {} }");
    assert!(pdo.is_none());
    assert_snapshot!(messages, @r#"
    error[unknown-key]: unknown key `nam`
     --> device.toml:1:39
      |
    1 | entries = ["controlword", { bits = 8, nam = "gap" }]
      |                                       ^^^ not a key of this table
      |
    help: did you mean `name`?
      |
    1 | entries = ["controlword", { bits = 8, name = "gap" }]
      |                                          +

    error[missing-key]: missing key `name`
     --> device.toml:2:14
      |
    2 | bits = { 0 = {} }
      |              ^^ `name` has to be given here
    "#);
    let (pdo, messages) = read::<Pdo>("entries = [\"controlword\", { bits = 8 }]\nbits = { 0 = \"ready\" }");
    assert_eq!(messages, "");
    let pdo = pdo.expect("a PDO");
    assert_eq!(
        pdo.entries.iter().map(|it| (it.entry.as_deref(), it.bits)).collect::<Vec<_>>(),
        [(Some("controlword"), None), (None, Some(8)),]
    );
    assert_eq!(pdo.bits.as_ref().map(|bits| bits[0].name.as_str()), Some("ready"));
    assert_snapshot!(read::<Pdo>("entries = [0x6040]").1, @r#"
    error[wrong-type]: expected the name or index of an entry, or a table with `entry`, `bits`, `type`, `name`, `names` and `about`, found an integer
     --> device.toml:1:12
      |
    1 | entries = [0x6040]
      |            ^^^^^^ in `entries`
      |
    help: an index stands in quotes
      |
    1 - entries = [0x6040]
    1 + entries = ["0x6040"]
      |
    "#);
    assert_snapshot!(read::<Pdo>("entries = [1]").1, @r"
    error[wrong-type]: expected the name or index of an entry, or a table with `entry`, `bits`, `type`, `name`, `names` and `about`, found an integer
     --> device.toml:1:12
      |
    1 | entries = [1]
      |            ^ in `entries`
    ");
    assert_snapshot!(read::<Pdo>("entries = [[\"a\", 1, \"b\"]]").1, @r#"
    error[wrong-type]: expected the name or index of an entry, or a table with `entry`, `bits`, `type`, `name`, `names` and `about`, found an array
     --> device.toml:1:12
      |
    1 | entries = [["a", 1, "b"]]
      |            ^^^^^^^^^^^^^ in `entries`
    "#);
}
