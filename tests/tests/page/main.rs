//! The reference as a page, in a real browser. Where there is none, each test says so and ends.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing, clippy::print_stderr)] // tests may

mod accessibility;
mod browser;
mod choice;
mod decoders;
mod pictures;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use browser::Browser;
use devc::emit::html::Html;
use devc::emit::json::Json;
use devc::emit::{self, Files, Options};
use devc::source::Disk;
use serde_json::Value;

const DEVICES: [&str; 3] = ["c887", "pmc-sc6", "s700"];

/// The outputs of each device, made once for all tests.
static OUTPUTS: LazyLock<BTreeMap<&str, Files>> =
    LazyLock::new(|| DEVICES.map(|device| (device, made(device))).into());

fn outputs(device: &str) -> &'static Files {
    &OUTPUTS[device]
}

fn made(device: &str) -> Files {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(device);
    let family = devc::compile(&Disk, &folder).family.expect("the description compiles");
    emit::emit(&family, &[&Html, &Json], &Options::default())
}

fn page(device: &str) -> String {
    outputs(device).text(".html").expect("a page").to_owned()
}

/// The page of a device, and the members of its model.
fn page_and_members(device: &str) -> (String, Vec<Value>) {
    let files = outputs(device);
    let model: Value = serde_json::from_str(files.text(".json").expect("a model")).expect("JSON");
    let members = model["members"].as_array().expect("members").clone();
    (files.text(".html").expect("a page").to_owned(), members)
}

/// Nothing is loaded, and the browser has nothing to complain of.
#[test]
fn the_browser_does_not_complain() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let complaints = browser.complaints(&page(device));
        assert!(complaints.is_empty(), "{device}: {complaints:?}");
    }
}

/// Nothing runs but the page's own script: the policy stops one that does not belong there.
#[test]
fn no_other_script_runs() {
    let Some(browser) = Browser::find() else { return };
    let foreign = page("c887").replacen("</body>", "<script>document.title = 'taken'</script></body>", 1);
    assert!(!browser.open(&foreign, "").contains("<title>taken"), "the policy holds");
}

/// On paper nothing is cut, on a dark ground, or there for those who can press it.
#[test]
fn what_is_printed_is_whole() {
    let Some(browser) = Browser::find() else { return };
    // the rules for paper, applied to a body as wide as what an A4 page takes
    let paper = "for (const rule of document.styleSheets[0].cssRules) { \
         if (rule.media?.mediaText === \"print\") rule.media.mediaText = \"all\"; } \
         document.documentElement.className = \"dark\"; document.body.style.width = \"180mm\"; \
         const edge = document.body.getBoundingClientRect().right + 1; \
         const shown = [...document.body.querySelectorAll(\"main *\")].filter((it) => it.checkVisibility()); \
         return [shown.filter((it) => it.getBoundingClientRect().right > edge).map((it) => it.textContent.slice(0, 60)), \
         shown.filter((it) => it.matches(\"input, select, button\")).map((it) => it.id), \
         getComputedStyle(document.body).backgroundColor, shown.length > 1000];";
    for device in DEVICES {
        let answer = browser.ask(&page(device), "", paper);
        assert_eq!(answer, serde_json::json!([[], [], "rgb(255, 255, 255)", true]), "{device}");
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
