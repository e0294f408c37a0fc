//! What devc knows of a word. The facts are those of CiA 402-2 (IEC 61800-7-201) and ETG.1000.6.

use super::Desk;

/// Asks, and gives back the answer; what devc lays out itself fits a terminal.
#[track_caller]
fn ask(words: &str, said: &[&str]) -> String {
    let question: Vec<&str> = ["explain"].into_iter().chain(words.split(' ')).collect();
    let answer = Desk::new(&[]).devc(&question).ends(0, said).out.clone();
    let long: Vec<&str> = answer.lines().filter(|line| line.chars().count() > 100).collect();
    assert!(long.is_empty() || answer.contains("## Fires"), "{long:?}");
    answer
}

#[track_caller]
fn fails(words: &str, said: &[&str]) {
    let question: Vec<&str> = ["explain"].into_iter().chain(words.split(' ')).collect();
    Desk::new(&[]).devc(&question).ends(2, said);
}

/// The lines of an answer that begin with a word.
fn lines<'a>(answer: &'a str, word: &str) -> Vec<Vec<&'a str>> {
    let lines = answer.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
    lines.filter(|line| line.first() == Some(&word)).collect()
}

#[test]
fn a_rule_comes_first() {
    let rules = Desk::new(&[]).devc(&["rules"]).out;
    for name in rules.lines().filter_map(|line| line.split_whitespace().next()) {
        ask(name, &[&format!("{name}: "), "## Fires", "## Silent"]);
    }
}

#[test]
fn a_profile_is_all_that_it_has() {
    let answer = ask("cia402", &["IEC 61800-7-201"]);
    let row = |key: &str| lines(&answer, key).concat().join(" ");
    assert_eq!(row("0x6064"), "0x6064 INT32 ro tx Position actual value");
    assert_eq!(row("0x60FE"), "0x60FE array of UINT32 rw rx Digital outputs");
    assert_eq!(row("operation-enabled"), "operation-enabled Operation enabled x01x 0111");
    assert_eq!(row("enable-operation"), "enable-operation Enable operation 0xxx 1111");
    assert_eq!(row("0x8611"), "0x8611 Following error");
    assert!(lines(&answer, "8").contains(&"8 csp Cyclic synchronous position mode".split(' ').collect()));
    for section in ["objects", "words", "states", "commands", "transitions", "modes", "errors"] {
        assert_eq!(lines(&answer, section), [[section]]);
    }
}

#[test]
fn an_index_is_found_in_whatever_profile_has_it() {
    for words in [
        "0x6064",
        "0X6064",
        "cia402 0x6064",
        "object 0x6064",
        "position-actual-value",
        "Position actual value",
    ] {
        let answer = ask(words, &["object 0x6064 of cia402: Position actual value"]);
        assert_eq!(lines(&answer, "type"), [["type", "INT32"]], "{words}");
        assert_eq!(lines(&answer, "access"), [["access", "ro"]], "{words}");
        assert_eq!(lines(&answer, "pdo"), [["pdo", "tx"]], "{words}");
    }
    ask("0x1018", &["of ethercat: Identity object", "2  Product code"]);
    fails("cia402 0x1018", &["did you mean `object 0x1018`?"]);
}

#[test]
fn an_entry_says_what_its_object_says_for_it() {
    let answer =
        ask("0x60FE:01", &["entry 0x60FE:01 of cia402: Physical outputs, in Digital outputs", "set brake"]);
    assert_eq!(lines(&answer, "type"), [["type", "UINT32"]]);
    let answer = ask("0x1C32:20", &["Sync error"]);
    assert_eq!(lines(&answer, "type"), [["type", "BOOL"]]);
    assert_eq!(lines(&answer, "pdo"), [["pdo", "tx"]]);
}

#[test]
fn an_object_with_bits_shows_them_with_what_modes_make_of_them() {
    let answer = ask(
        "statusword",
        &["object 0x6041", "3   fault", "mode 6: homing error", "mode 1: set-point acknowledge"],
    );
    assert_eq!(answer.matches("ready to switch on").count(), 1, "the word is not shown a second time");
    ask("word statusword", &["word statusword of cia402", "3   fault"]);
}

#[test]
fn codes_are_found_in_hex_and_in_decimal() {
    for words in ["0x7305", "29445", "error 0x7305", "Incremental sensor 1 fault"] {
        ask(words, &["error 0x7305 of cia402: Incremental sensor 1 fault"]);
    }
    ask("0xFF7F", &["error 0xFF00..=0xFFFF of cia402: Manufacturer-specific"]);
    for words in ["0x001B", "AL status code 0x1b", "ethercat 0x001B"] {
        ask(words, &["AL status code 0x001B of ethercat: Sync manager watchdog"]);
    }
    ask("operational", &["communication state operational of ethercat"]);
    let answer = ask("communication-state 8", &["communication state operational"]);
    assert_eq!(lines(&answer, "entered"), [["entered", "by", "communication", "transition", "SO"]]);
}

#[test]
fn a_number_of_several_things_is_narrowed_by_their_kind() {
    let all = ask("8", &["mode 8 of cia402", "transition 8 of cia402", "communication state operational"]);
    let one = ask("mode 8", &["mode 8 of cia402: Cyclic synchronous position mode"]);
    assert!(all.contains(&one) && !one.contains("transition"));
    assert_eq!(ask("csp", &[]), one);
    assert_eq!(ask("cia402 Modes 8", &[]), one);
    let answer = ask("transition 4", &[]);
    assert_eq!(lines(&answer, "set"), [["set", "off", "by", "command", "enable-operation"]]);
    let modes = ask("cia402 modes", &["8   csp"]);
    assert_eq!(ask("mode", &[]), modes);
}

#[test]
fn unknown_words_are_answered_with_those_that_look_like_them() {
    fails("unknown-kye", &["nothing is known of `unknown-kye`", "did you mean `unknown-key`"]);
    fails("tareget position", &["did you mean `target-position`?"]);
    fails("homing", &["`homing-method`, `homing-speeds`"]);
    fails("0x605F", &["`object 0x605E`, `object 0x6060`"]);
    fails("mode 11", &["did you mean `mode 10`, `mode 9`"]);
    fails("cai402", &["did you mean `cia402`?"]);
    fails("0x60FE:09", &["nothing is known of `0x60FE:09`"]);
    fails("nonsense", &["`devc rules` lists all rules", "`devc explain cia402`"]);
}

/// What the words mean is from the tables of CiA 402-2 (IEC 61800-7-201): the states and the commands by their bits.
#[test]
fn a_drive_is_asked_for_its_words() {
    let desk = Desk::new(&[]);
    desk.devc(&["new", "devices/d", "--mode", "csp,hm"]).ends(0, &[]);
    let asked = |word, value| desk.devc(&["explain", "devices/d", word, value]).out;
    for (value, state) in [
        ("0x0250", "Switch on disabled"),
        ("0x0231", "Ready to switch on"),
        ("0x0233", "Switched on"),
        ("0x0237", "Operation enabled"),
        ("0x0217", "Quick stop active"),
        ("0x021F", "Fault reaction active"),
        ("536", "Fault"),
    ] {
        let answer = asked("status", value);
        assert!(answer.contains(&format!("  shows {state}\n")), "{value}: {answer}");
    }
    for (value, command) in [("0x06", "Shutdown"), ("0x0F", "Enable operation"), ("0x00", "Disable voltage")]
    {
        let answer = asked("controlword", value);
        assert!(answer.contains(&format!("  asks for {command}\n")), "{value}: {answer}");
    }
    assert!(asked("object", "0x2000").contains("Ramp time"));
    desk.devc(&["explain", "devices/d", "error", "0x7305"]).ends(2, &["nothing is known"]);
}

/// The codes are those of ETG.1000.6; they hold for every device.
#[test]
fn an_abort_code_is_told() {
    for words in ["0x06040041", "abort 0x06040041", "SDO abort code 0x06040041", "not mappable"] {
        ask(words, &["SDO abort code 0x06040041 of ethercat: Not mappable", "ETG.1000.6"]);
    }
    let desk = Desk::new(&[("drive", BYTES)]);
    desk.devc(&["explain", "devices/drive", "abort", "0x06010003"]).ends(0, &["Subindex 0 is not 0"]);
}

const BYTES: &str = r#"
source   = "page 7"
profiles = ["ethercat", "cia402"]

[device]
name   = "Drive"
vendor = "Example"

[identity]
vendor-id    = 0x76D
product-code = 3
revision     = 1

[units.speed]
quantity     = "velocity"
symbol       = "rpm"
raw-per-unit = 10

[objects.0x1001]
[objects.0x6041]
[objects.0x2000]
name = "Speed"
type = "INT16"
unit = "speed"
[objects.0x2001]
name   = "Direction"
type   = "BIT2"
values = { 0 = "none", 2 = "left" }

[words.statusword]

[states.operation-enabled]

[errors.0x2310]
remedy = "Move less."

[tx-pdos.0x1A00]
name    = "Inputs"
entries = ["statusword", "speed", "direction", { bits = 6 }]

[telegrams.hello]
name = "Hello"
[telegrams.hello.bytes]
0        = { name = "service", values = { 7 = "greet" } }
"1..=2"  = "number"
"#;

/// 0x0237 is Operation enabled, and 0x2310 continuous overcurrent (CiA 402); -1500 of ten to the rpm are -150 rpm.
#[test]
fn bytes_are_taken_apart_for_a_drive() {
    let desk = Desk::new(&[("drive", BYTES)]);
    for pdo in ["0x1A00", "inputs"] {
        let said =
            ["bytes 0 to 1", "0x6041:00", "shows Operation enabled", "-1500, -150 rpm", "2: left", "page 7"];
        desk.devc(&["explain", "devices/drive", pdo, "37 02 24 FA 02"]).ends(0, &said);
        desk.devc(&["explain", "devices/drive", pdo, "37", "02", "24", "FA", "02"]).ends(0, &said);
    }
    desk.devc(&["explain", "devices/drive", "0x1A00", "37 02"]).ends(0, &["There are 2 bytes", "missing"]);
    let said = ["error 0x2310, Continuous over", "0x02", "01 02 03 04 05", "Move less.", "page 7"];
    desk.devc(&["explain", "devices/drive", "emcy", "10 23 02 01 02 03 04 05"]).ends(0, &said);
    desk.devc(&["explain", "devices/drive", "emcy", "00 00 00 00 00 00 00 00"])
        .ends(0, &["no error any more"]);
    desk.devc(&["explain", "devices/drive", "hello", "07 34 12"]).ends(0, &["07: greet", "34 12", "page 7"]);
    desk.devc(&["explain", "devices/drive", "0x1A01", "07 34 12"]).ends(2, &["nothing is known"]);
}
