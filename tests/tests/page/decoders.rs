//! The decoders, against the models, the runtime and the generated code.

use devc_generated::c887::{Controlword, RxPdo1600};
use devc_runtime::sdo::AbortCode;
use serde_json::{Value, json};

use crate::browser::{Browser, text_of};
use crate::{DEVICES, page, page_and_members};

/// What decoders say, each asked by a link: the end of it, and where the answer stands.
fn decoded(browser: &Browser, page: &str, links: &[(&str, &str)]) -> Vec<String> {
    let links = serde_json::to_string(links).expect("JSON");
    let function = r##"
        return LINKS.map(([link, out]) => {
          history.replaceState(null, "", "#" + link);
          fromLink();
          return Array.from(byId(out).querySelectorAll("p, td"), (part) => part.textContent).join(" ").replace(/\s+/g, " ");
        });"##;
    let answer = browser.ask(page, "", &function.replace("LINKS", &links));
    serde_json::from_value(answer).expect("texts")
}

/// The figures are those of the manuals: the states of the statusword, the layout of a PDO, an error.
#[test]
fn links_open_the_decoders() {
    let Some(browser) = Browser::find() else { return };
    let asked = [
        ("word=statusword&value=0x0637", "word-out", "0x0637: Operation enabled"),
        ("word=statusword&value=0x10000", "word-out", "no word of 16 bits"),
        ("word=controlword&value=0x000F", "word-out", "0x000F: enable operation (4)"),
        ("code=abort_codes&value=0x06020000", "code-out", "the object is not in the dictionary"),
        ("pdo=0x1600&value=0F00 08 79FEFFFF", "pdo-out", "0x607A:00 Target position -391"),
        ("pdo=0x1600&value=0F", "pdo-out", "these are 1"),
    ];
    let links = asked.map(|(link, out, _)| (link, out));
    for (said, (link, _, expected)) in decoded(&browser, &page("c887"), &links).iter().zip(asked) {
        assert!(said.contains(expected), "{link}: {said}");
    }
    // once as a reader opens it, with the policy of the page
    let document = browser.open(&page("s700"), "member=s400&code=al_status_codes&value=0x0017");
    let code = text_of(&document, "code-out");
    assert!(code.contains("Invalid sync manager configuration"), "{code}");
}

/// The mask, the value and the edges of a pattern, as it is written: the highest bit first.
fn bits(pattern: &str) -> (u32, u32) {
    pattern.chars().filter(|c| *c != ' ').fold((0, 0), |(mask, value), bit| match bit {
        '0' | 'f' => (mask << 1 | 1, value << 1),
        '1' | 'r' => (mask << 1 | 1, value << 1 | 1),
        _ => (mask << 1, value << 1),
    })
}

/// Things with patterns of a member: what they are called, and the bits.
fn patterns<'m>(member: &'m Value, key: &str, wanted: fn(&Value) -> bool) -> Vec<(&'m Value, u32, u32)> {
    let all = member[key].as_array().expect("a list").iter().filter(|one| wanted(one));
    let patterns = all.filter_map(|one| {
        let (mask, value) = bits(one["pattern"].as_str()?);
        Some((one, mask, value))
    });
    patterns.collect()
}

/// The sum over the texts for all words, as the page sums them.
fn sum(text: impl Fn(u32) -> String) -> u32 {
    (0..0x1_0000_u32).fold(0, |sum, word| {
        text(word)
            .encode_utf16()
            .fold(sum, |sum, unit| sum.wrapping_mul(31).wrapping_add(unit.into()) & 0x7FFF_FFFF)
    })
}

/// A script that sums over the answers for all words, for each member.
const ASK_ALL: &str = r#"
    const all = (text) => {
      let sum = 0;
      for (let word = 0; word < 65536; word++) {
        for (const unit of text(word)) sum = (Math.imul(sum, 31) + unit.charCodeAt(0)) & 0x7FFFFFFF;
      }
      return sum;
    };
    const numbers = (word) => member.asked.filter((one) => (word & one.mask) === one.value).map((one) => one.transitions.join("+"));
    return data.members.map((one, place) => {
      choose(place);
      return [all((word) => states(word).join(",")), all((word) => numbers(word).join(","))];
    });"#;

/// Asked for all 65 536 words, the page names the states whose patterns fit a statusword, and the transitions that a
/// controlword asks for, for each member of each family.
#[test]
fn every_word_means_what_its_patterns_say() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let (page, members) = page_and_members(device);
        let answers = browser.ask(&page, "", ASK_ALL);
        for (member, answer) in members.iter().zip(answers.as_array().expect("an answer for each")) {
            let states = patterns(member, "states", |_| true);
            let shown = sum(|word| {
                let shown = states.iter().filter(|(_, mask, value)| word & mask == *value);
                let names = shown.map(|(state, ..)| state["name"].as_str().expect("a name"));
                names.collect::<Vec<_>>().join(",")
            });
            assert_eq!(answer[0], shown, "{device}: {}", member["id"]);

            let made = |number: &Value| {
                let all = member["transitions"].as_array().expect("transitions").iter();
                !all.clone().any(|one| one["number"] == *number && one["supported"] == false)
            };
            let commands = patterns(member, "commands", |_| true);
            let own =
                patterns(member, "transitions", |one| one["supported"] == true && one["automatic"] == false);
            let asked = sum(|word| {
                let fits = |(_, mask, value): &&(&Value, u32, u32)| word & mask == *value;
                let of_command = commands.iter().filter(fits).map(|(command, ..)| {
                    let numbers = command["transitions"].as_array().expect("numbers").iter();
                    numbers.filter(|number| made(number)).map(Value::to_string).collect::<Vec<_>>().join("+")
                });
                let own = own.iter().filter(fits).map(|(transition, ..)| transition["number"].to_string());
                of_command.chain(own).collect::<Vec<_>>().join(",")
            });
            assert_eq!(answer[1], asked, "{device}: {}", member["id"]);
        }
    }
}

/// Every abort code is what the runtime says, and there are no others.
#[test]
fn abort_codes_are_those_of_the_runtime() {
    let Some(browser) = Browser::find() else { return };
    let answer = browser.ask(
        &page("s700"),
        "",
        "return codeList('abort_codes').map((one) => [one.first, codes(codeList('abort_codes'), BigInt(one.first))[0].name]);",
    );
    let named = AbortCode::NAMED.iter().map(|code| json!([code.0, code.meaning()]));
    assert_eq!(answer, named.collect::<Value>());
}

/// Errors, the vendor's codes and those of the state machine are found by number, in ranges too.
#[test]
fn codes_are_those_of_the_model() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let (page, members) = page_and_members(device);
        let answer = browser.ask(
            &page,
            "",
            r#"
            return data.members.map((one, place) => {
              choose(place);
              return ["errors", "vendor_codes", "al_status_codes"].map((list) =>
                codeList(list).map((code) => [code.last, codes(codeList(list), BigInt(code.last)).map((found) => found.name)]));
            });"#,
        );
        for (member, answer) in members.iter().zip(answer.as_array().expect("an answer for each")) {
            for (key, answer) in
                ["errors", "vendor_codes", "al_status_codes"].iter().zip(answer.as_array().expect("lists"))
            {
                let all = member[key].as_array().expect("a list");
                let last = |one: &Value| one.get("last").unwrap_or(&one["code"]).as_u64();
                let names = |number: Option<u64>| {
                    let of = all.iter().filter(|one| one["code"].as_u64() <= number && number <= last(one));
                    of.map(|one| one["name"].clone()).collect::<Vec<_>>()
                };
                let expected: Value = all.iter().map(|one| json!([last(one), names(last(one))])).collect();
                assert_eq!(*answer, expected, "{device}: {}: {key}", member["id"]);
            }
        }
    }
}

/// Of every PDO, every field is read from the bits that the model gives it, with its sign.
#[test]
fn fields_are_read_from_their_bits() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let (page, members) = page_and_members(device);
        let answer = browser.ask(
            &page,
            "",
            r#"
            const byte = (at) => (at * 167 + 201) & 255;
            return data.members.map((one) => one.pdos.map((pdo) => {
              const bytes = Array.from({ length: Math.ceil(pdo.bits / 8) }, (_, at) => byte(at));
              return pdo.fields.map((field) => String(raw(field, bytes)));
            }));"#,
        );
        let bit = |at: u64| (at / 8 * 167 + 201) >> (at % 8) & 1;
        for (member, answer) in members.iter().zip(answer.as_array().expect("an answer for each")) {
            let field = |field: &Value| {
                let (offset, bits) =
                    (field["offset"].as_u64().expect("a bit"), field["bits"].as_u64().expect("bits"));
                let value: i128 = (0..bits).map(|place| i128::from(bit(offset + place)) << place).sum();
                let is_signed = field["data_type"].as_str().is_some_and(|name| name.starts_with("INT"));
                let value = if is_signed && value >> (bits - 1) == 1 { value - (1 << bits) } else { value };
                Value::from(value.to_string())
            };
            let pdos = member["pdos"].as_array().expect("PDOs").iter();
            let expected: Value = pdos
                .map(|pdo| pdo["entries"].as_array().expect("fields").iter().map(field).collect::<Value>())
                .collect();
            assert_eq!(*answer, expected, "{device}: {}", member["id"]);
        }
    }
}

/// What generated code packs, the page reads.
#[test]
fn packed_process_data_is_read() {
    let Some(browser) = Browser::find() else { return };
    let pdo =
        RxPdo1600 { controlword: Controlword(0x001F), modes_of_operation: 8, target_position: -1_234_567 };
    let hex: String = pdo.pack().iter().map(|byte| format!("{byte:02X}")).collect();
    let link = format!("pdo=0x1600&value={hex}");
    let read = decoded(&browser, &page("c887"), &[(&link, "pdo-out")]).concat();
    for part in ["31 0x001F", "-1234567 0xFFED2979 -12.34567 mm", "8 0x08 cyclic synchronous position mode"] {
        assert!(read.to_lowercase().contains(&part.to_lowercase()), "{part} is not in {read}");
    }
}

/// A physical value becomes the nearest raw one, and the other way round, as the runtime scales: 100 000 steps are a
/// millimetre.
#[test]
fn quantities_are_converted() {
    let Some(browser) = Browser::find() else { return };
    let answer = browser.ask(
        &page("c887"),
        "",
        r#"
        const unit = { symbol: "mm", raw: 100000, units: 1 };
        return [steps("12.5", unit), steps("-0,00001", unit), steps("x", unit)].map(String)
          .concat([physical(1250000n, unit), physical(-1n, unit)]);"#,
    );
    assert_eq!(answer, json!(["1250000", "-1", "null", "12.5 mm", "-0.00001 mm"]));
}
