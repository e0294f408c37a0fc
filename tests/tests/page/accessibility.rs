//! What axe, which judges pages by the accessibility guidelines (WCAG), says of the pages, in light and in dark. Without it the test says
//! so and ends.

use std::fs;
use std::path::Path;

use crate::browser::Browser;
use crate::{DEVICES, page};

/// Axe as `.ci/run` brings it.
fn axe() -> Option<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/axe/package/axe.min.js");
    let script = fs::read_to_string(path).ok();
    if script.is_none() {
        eprintln!("target/axe/package/axe.min.js is not there: accessibility is not looked at");
    }
    script
}

/// What it finds in light and in dark, which it looks at one after the other.
const JUDGE: &str = r#"
    const judge = (scheme) => {
      turn(scheme);
      return axe.run(document, { resultTypes: ["violations"] }).then((found) => found.violations.map((one) =>
        `${scheme}: ${one.id}: ${one.help}: ${one.nodes.map((node) => node.html.slice(0, 120)).slice(0, 3).join(" ")}`));
    };
    return judge("light").then((light) => judge("dark").then((dark) => light.concat(dark)));"#;

#[test]
fn pages_keep_to_the_guidelines() {
    let (Some(browser), Some(axe)) = (Browser::find(), axe()) else { return };
    for device in DEVICES {
        let answer = browser.ask(&page(device), &axe, JUDGE);
        assert_eq!(answer, serde_json::json!([]), "{device}");
    }
}

/// The judge is known to judge: an image without words is found.
#[test]
fn a_page_that_does_not_keep_to_them_is_found() {
    let (Some(browser), Some(axe)) = (Browser::find(), axe()) else { return };
    let small =
        "<html lang=\"en\"><title>x</title><body><main><h1>x</h1><img src=\"data:,\"></main></body></html>";
    let answer = browser.ask(small, &axe, &JUDGE.replace("turn(scheme);", ""));
    assert!(answer.to_string().contains("image-alt"), "{answer}");
}
