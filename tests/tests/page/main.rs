//! The reference as a page, in a real browser. Where there is none, each test says so and ends.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing, clippy::print_stderr)] // tests may

mod browser;

use std::path::Path;

use browser::{Browser, text_of};
use devc::emit::html::Html;
use devc::emit::json::Json;
use devc::emit::{self, Files, Options};
use devc::source::Disk;
use serde_json::Value;

const DEVICES: [&str; 3] = ["c887", "pmc-sc6", "s700"];

fn outputs(device: &str) -> Files {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(device);
    let family = devc::compile(&Disk, &folder).family.expect("the description compiles");
    emit::emit(&family, &[&Html, &Json], &Options::default())
}

fn page(device: &str) -> String {
    outputs(device).text(".html").expect("a page").to_owned()
}

/// What a member's decoder says, opened by a link.
fn decoded(browser: &Browser, page: &str, link: &str, output: &str) -> String {
    let document = browser.open(page, link);
    text_of(&document, output)
}

/// The figures are those of the manuals: the states of the statusword, the layout of a PDO, an error.
#[test]
fn links_open_the_decoders() {
    let Some(browser) = Browser::find() else { return };
    let c887 = page("c887");
    let word = decoded(&browser, &c887, "word=statusword&value=0x0637", "word-out");
    assert!(word.contains("0x0637: Operation enabled"), "{word}");
    let word = decoded(&browser, &c887, "word=statusword&value=0x10000", "word-out");
    assert!(word.contains("no word of 16 bits"), "{word}");
    let bytes = decoded(&browser, &c887, "pdo=0x1600&value=0F00 08 79FEFFFF", "pdo-out");
    for part in ["0x6040", "15", "0x6060", "8", "0x607A", "-391"] {
        assert!(bytes.contains(part), "{part} is not in {bytes}");
    }
    let short = decoded(&browser, &c887, "pdo=0x1600&value=0F", "pdo-out");
    assert!(short.contains("these are 1"), "{short}");
    let s700 = page("s700");
    let code = decoded(&browser, &s700, "member=s400&code=al_status_codes&value=0x0017", "code-out");
    assert!(code.contains("Invalid sync manager configuration"), "{code}");
}

/// The mask and the value of a pattern, as it is written: the highest bit first.
fn mask_and_value(pattern: &str) -> (u32, u32) {
    pattern.chars().filter(|c| *c != ' ').fold((0, 0), |(mask, value), bit| match bit {
        '0' => (mask << 1 | 1, value << 1),
        '1' => (mask << 1 | 1, value << 1 | 1),
        _ => (mask << 1, value << 1),
    })
}

/// Asked for all 65 536 words, the page names the states whose patterns fit, for each member of each family.
#[test]
fn every_word_shows_the_states_of_its_patterns() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let files = outputs(device);
        let model: Value = serde_json::from_str(files.text(".json").expect("a model")).expect("JSON");
        let page = files.text(".html").expect("a page");
        // the policy forbids other scripts, which is the point of it
        let open = page.replacen("http-equiv=\"Content-Security-Policy\"", "name=\"policy\"", 1);
        let asked = open.replacen("</body>", ASK_ALL, 1);
        let answers = text_of(&browser.open(&asked, ""), "answers");
        let mut answers = answers.split(';');
        for member in model["members"].as_array().expect("members") {
            let states: Vec<(String, u32, u32)> = member["states"]
                .as_array()
                .expect("states")
                .iter()
                .filter_map(|state| {
                    let (mask, value) = mask_and_value(state["pattern"].as_str()?);
                    Some((state["name"].as_str()?.to_owned(), mask, value))
                })
                .collect();
            let mut sum = 0_u32;
            for word in 0..0x1_0000_u32 {
                let shown = states.iter().filter(|(_, mask, value)| word & mask == *value);
                let names: Vec<&str> = shown.map(|(name, ..)| name.as_str()).collect();
                sum = names
                    .join(",")
                    .encode_utf16()
                    .fold(sum, |sum, unit| sum.wrapping_mul(31).wrapping_add(unit.into()) & 0x7FFF_FFFF);
            }
            assert_eq!(answers.next(), Some(sum.to_string().as_str()), "{device}: {}", member["id"]);
        }
    }
}

/// A script that puts down a sum over the answers for all words, for each member.
const ASK_ALL: &str = r#"<p id="answers"></p><script>
const sums = data.members.map((one, place) => {
  choose(place);
  let sum = 0;
  for (let word = 0; word < 65536; word++) {
    for (const unit of states(word).join(",")) sum = (Math.imul(sum, 31) + unit.charCodeAt(0)) & 0x7FFFFFFF;
  }
  return sum;
});
document.getElementById("answers").textContent = sums.join(";");
</script></body>"#;

/// A physical value becomes the nearest raw one, and the other way round: 100 000 steps are a millimetre.
#[test]
fn quantities_are_converted() {
    let Some(browser) = Browser::find() else { return };
    let open = page("c887").replacen("http-equiv=\"Content-Security-Policy\"", "name=\"policy\"", 1);
    let asked = open.replacen(
        "</body>",
        r#"<p id="answers"></p><script>
const unit = { symbol: "mm", raw: 100000, units: 1 };
document.getElementById("answers").textContent =
  [steps("12.5", unit), steps("-0,00001", unit), steps("x", unit), physical(1250000n, unit), physical(-1n, unit)].join(" | ");
</script></body>"#,
        1,
    );
    let answers = text_of(&browser.open(&asked, ""), "answers");
    assert_eq!(answers, "1250000 | -1 | | 12.5 mm | -0.00001 mm");
}

/// Nothing runs but the page's own script, nothing is loaded, and the browser has nothing to complain of.
#[test]
fn the_browser_does_not_complain() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let complaints = browser.complaints(&page(device));
        assert!(complaints.is_empty(), "{device}: {complaints:?}");
        // the same with a script that does not belong there: the policy stops it, and says so
        let foreign = page(device).replacen("</body>", "<script>document.title = 'taken'</script></body>", 1);
        assert!(!browser.open(&foreign, "").contains("<title>taken"), "the policy holds");
    }
}

#[test]
fn each_link_of_a_page_leads_somewhere() {
    for device in DEVICES {
        let page = page(device);
        let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        let links = page.split("href=\"#").skip(1).filter_map(|rest| rest.split('"').next());
        let lost: Vec<&str> = links.filter(|link| !ids.contains(link)).collect();
        assert!(lost.is_empty(), "{device}: {lost:?}");
        let mut twice = ids.clone();
        twice.sort_unstable();
        let twice: Vec<_> = twice.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]).collect();
        assert!(twice.is_empty(), "{device}: {twice:?}");
    }
}
