//! Process data: by default, by what start-up lists assign and map, and by what someone says who looks at it.

use serde_json::Value as Json;

use super::capture::{Capture, LRW, STATION};
use super::{Reader, filter, mailbox};
use crate::expected::bytes;
use crate::model::{Field, Print, Record, list, name, number, records, set, subjects, text, word};

/// A frame with process data, and what it holds.
struct Sent<'r> {
    frame: usize,
    record: &'r Record,
    sample: Vec<u8>,
}

/// A way to set a device up, with what it exchanges then: outputs, inputs.
struct Way<'j> {
    prefix: String,
    configuration: Option<&'j Json>,
}

fn ways(member: &Json) -> Vec<Way<'_>> {
    let default = Way { prefix: String::new(), configuration: None };
    let chosen = list(member, "configurations").iter().map(|configuration| Way {
        prefix: format!("{}_", name(text(configuration, "id"), &[])),
        configuration: Some(configuration),
    });
    std::iter::once(default).chain(chosen).collect()
}

impl Way<'_> {
    /// What it exchanges: what it chooses, or for a direction that it does not choose, the default.
    fn images<'r>(&self, records: &'r [Record]) -> [Option<&'r Record>; 2] {
        ["outputs", "inputs"].map(|what| {
            let find = |name: String| records.iter().find(|record| record.name == name);
            find(format!("{}{what}", self.prefix)).or_else(|| find(what.to_owned()))
        })
    }
}

/// Texts of letters, so that they are texts.
fn readable(record: &Record, mut sample: Vec<u8>) -> Vec<u8> {
    for field in record.fields.iter().filter(|field| field.data_type.starts_with("STRING")) {
        for byte in 0..field.bits / 8 {
            let letter = b'A' + u8::try_from(byte).unwrap();
            (0..8).for_each(|bit| set(&mut sample, field.offset + byte * 8 + bit, letter >> bit & 1 == 1));
        }
    }
    sample
}

/// Sets a station up and sends process data of each direction.
fn exchange<'r>(
    capture: &mut Capture,
    member: &Json,
    way: &Way<'_>,
    records: &'r [Record],
    at: u32,
) -> Vec<Sent<'r>> {
    for write in way.configuration.into_iter().flat_map(|it| list(it, "startup")) {
        let address = (number(&write["address"], "index"), number(&write["address"], "subindex"));
        capture.download(mailbox(member), address, &bytes(&write["data"]));
    }
    let mut sent = Vec::new();
    let mut logical = at;
    for (unit, (image, is_output)) in way.images(records).into_iter().zip([true, false]).enumerate() {
        let Some(record) = image else { continue };
        let length = record.bytes();
        capture.unit(u16::try_from(unit).unwrap(), logical, length, 0x1800, is_output);
        for sample in record.samples() {
            let sample = readable(record, sample);
            let (low, high) = (logical as u16, (logical >> 16) as u16);
            capture.datagram(LRW, low, high, &sample, if is_output { 0 } else { 3 });
            sent.push(Sent { frame: capture.frames, record, sample });
        }
        logical += u32::try_from(length).unwrap();
    }
    sent
}

/// What is asked of Wireshark: filters, and how to find in a field what they have to be.
struct Question {
    filter: String,
    address: (usize, usize),
    /// Bits of a word.
    part: Option<(usize, usize)>,
    /// The states that a word shows.
    is_state: bool,
}

fn questions(member: &Json, records: &[Record]) -> Vec<Question> {
    let mut questions: Vec<Question> = Vec::new();
    for field in records.iter().flat_map(|record| &record.fields) {
        if questions.iter().any(|known| known.address == field.address) {
            continue;
        }
        let filter = filter(member, field.address, field.path.rsplit('.').next().unwrap());
        let (index, subindex) = field.address;
        let address = serde_json::json!({ "index": index, "subindex": subindex });
        let ask = |end: &str, part, is_state| Question {
            filter: format!("{filter}{end}"),
            address: field.address,
            part,
            is_state,
        };
        questions.push(ask("", None, false));
        let Some(word) = word(member, &address) else { continue };
        for bits in list(word, "fields") {
            if bits["reserved"] == false && bits["per_mode"] == false {
                let part = Some((number(bits, "low"), number(bits, "high")));
                questions.push(ask(&format!(".{}", name(text(bits, "id"), &[])), part, false));
            }
        }
        if text(word, "id") == "statusword" {
            questions.push(ask(".state", None, true));
        }
    }
    questions
}

/// The state that a word shows, by the patterns; none if it shows none.
fn state(member: &Json, word: u64) -> Option<String> {
    let shows = |pattern: &str| {
        let digits = pattern.chars().filter(|c| *c != ' ').rev().enumerate();
        digits.into_iter().all(|(bit, digit)| match digit {
            '0' => word >> bit & 1 == 0,
            '1' => word >> bit & 1 == 1,
            _ => true,
        })
    };
    let states = list(member, "states").iter();
    let mut shown = states.filter(|state| state["pattern"].as_str().is_some_and(shows));
    shown.next().map(|state| text(state, "name").to_owned())
}

/// A field as Wireshark prints it.
fn printed(field: &Field, sample: &[u8]) -> String {
    let hex = field.printed(sample);
    let raw: Vec<u8> =
        (0..hex.len()).step_by(2).map(|at| u8::from_str_radix(&hex[at..at + 2], 16).unwrap()).collect();
    match field.print() {
        Print::Bytes if field.data_type.starts_with("STRING") => String::from_utf8(raw).unwrap(),
        Print::Bytes => hex,
        Print::Real if raw.len() == 4 => f64::from(f32::from_le_bytes(raw.try_into().unwrap())).to_string(),
        Print::Real => f64::from_le_bytes(raw.try_into().unwrap()).to_string(),
        Print::Number => {
            let number = i64::from_le_bytes(raw.try_into().unwrap());
            let is_signed = field.data_type.starts_with("INT") && !field.is_word;
            let digits = if field.bits > 16 {
                8
            } else if field.bits > 8 {
                4
            } else {
                2
            };
            match () {
                () if field.is_word => format!("0x{number:0digits$x}"),
                () if is_signed => number.to_string(),
                () => number.cast_unsigned().to_string(),
            }
        }
    }
}

/// What a question has to be answered with: a value for each field of the address, as a text to compare.
fn expected(member: &Json, question: &Question, sent: &Sent<'_>) -> Vec<String> {
    let fields = sent.record.fields.iter().filter(|field| field.address == question.address);
    let of = |field: &Field| {
        let word = || {
            let bit =
                |at: usize| u64::from(sent.sample[(field.offset + at) / 8] >> ((field.offset + at) % 8) & 1);
            (0..field.bits.min(64)).map(|at| bit(at) << at).sum::<u64>()
        };
        match question.part {
            Some((low, high)) => Some((word() >> low & ((1 << (high - low + 1)) - 1)).to_string()),
            None if question.is_state => state(member, word()),
            None => Some(printed(field, &sent.sample)),
        }
    };
    fields.filter_map(of).collect()
}

/// Whether two texts say the same: newer versions print words for bits, and fractions have six digits.
fn same(found: &str, expected: &str) -> bool {
    let found = match found {
        "True" => "1",
        "False" => "0",
        found => found,
    };
    let is_fraction = [found, expected].iter().any(|text| text.contains('.'));
    match (found.parse::<f64>(), expected.parse::<f64>()) {
        (Ok(one), Ok(two)) if is_fraction => (one - two).abs() <= two.abs() * 1e-5,
        _ => found == expected,
    }
}

fn compare(
    reader: &Reader,
    member: &Json,
    capture: &Capture,
    options: &[&str],
    sent: &[Sent<'_>],
    all: &[Record],
) {
    let questions = questions(member, all);
    let mut filters: Vec<String> = questions.iter().map(|question| question.filter.clone()).collect();
    filters.push("mismatch".to_owned());
    let found = reader.read(capture, options, &filters);
    for sent in sent.iter().filter(|sent| sent.record.bytes() > 0) {
        let what = format!("{}, {}, frame {}", text(member, "id"), sent.record.name, sent.frame);
        let frame = found.get(&sent.frame).unwrap_or_else(|| panic!("{what} is not dissected"));
        assert_eq!(frame.last().unwrap(), &[""; 0], "{what}");
        for (question, found) in questions.iter().zip(frame) {
            let expected = expected(member, question, sent);
            let equal = found.len() == expected.len() && found.iter().zip(&expected).all(|(a, b)| same(a, b));
            assert!(equal, "{what}: {} is {found:?}, not {expected:?}", question.filter);
        }
    }
}

#[test]
fn wireshark_finds_in_process_data_what_the_model_says() {
    for subject in subjects() {
        for member in &subject.members {
            let Some(reader) = Reader::of(&subject, member) else { return };
            let (records, mut capture, mut sent) = (records(member, &[]), Capture::new(), Vec::new());
            for (number, way) in ways(member).iter().enumerate() {
                let number = u16::try_from(number).unwrap();
                capture.at(STATION + number);
                let logical = 0x1_0000 + u32::from(number) * 0x1000;
                sent.extend(exchange(&mut capture, member, way, &records, logical));
            }
            assert!(!sent.is_empty(), "{} has process data", text(member, "id"));
            compare(&reader, member, &capture, &[], &sent, &records);
        }
    }
}

/// A capture that begins in Operational shows neither units nor assignment.
#[test]
fn what_a_capture_does_not_show_can_be_said() {
    let subject = subjects().into_iter().find(|subject| subject.id == "s700").unwrap();
    let member = subject.members.iter().find(|member| text(member, "id") == "s300").unwrap();
    let Some(reader) = Reader::of(&subject, member) else { return };
    let records = records(member, &[]);
    // the numbers of those that choose process data, in order
    for (number, way) in ways(member).iter().enumerate() {
        let (mut capture, mut sent) = (Capture::new(), Vec::new());
        for (image, (low, counter)) in way.images(&records).into_iter().zip([(0x100_u16, 0), (0x200, 3)]) {
            let record = image.unwrap();
            for sample in record.samples() {
                capture.datagram(LRW, low, 0, &sample, counter);
                sent.push(Sent { frame: capture.frames, record, sample });
            }
        }
        let chosen = match way.configuration {
            Some(configuration) => format!("configuration:{}", text(configuration, "name")),
            None => "configuration:as the capture shows, or by default".to_owned(),
        };
        assert!(number < 3);
        let options = ["stations:0x1001", "outputs:0x100", "inputs:0x200", &chosen];
        compare(&reader, member, &capture, &options, &sent, &records);
    }
}

/// Of bytes that are not as described, none is shown as if it were.
#[test]
fn another_length_is_said() {
    let subject = subjects().into_iter().find(|subject| subject.id == "c887").unwrap();
    let member = &subject.members[0];
    let Some(reader) = Reader::of(&subject, member) else { return };
    let mut capture = Capture::new();
    capture.unit(0, 0x1_0000, 40, 0x1100, true);
    capture.datagram(LRW, 0, 1, &[0; 40], 0);
    let frame = &reader.read(&capture, &[], &["mismatch".to_owned(), "x.controlword".to_owned()])[&2];
    // six controlwords, modes and target positions
    assert_eq!(frame[0], ["description 42 bytes, frame 40"]);
    assert!(frame[1].is_empty());
}
