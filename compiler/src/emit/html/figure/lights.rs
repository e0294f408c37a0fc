//! Lights, and how they blink: the times are those of ETG.1300, indicator and labeling.

use std::fmt::Write;

use minijinja::HtmlEscape;

use crate::emit::markdown::Light;

/// What lights show: a word for it, and for how many milliseconds a light is on and off in turn.
const PATTERNS: [(&str, &[usize]); 8] = [
    ("off", &[]),
    ("on", &[2400]),
    ("flickering", &[50, 50]),
    ("blinking", &[200, 200]),
    ("single flash", &[200, 1000]),
    ("double flash", &[200, 200, 200, 1000]),
    ("triple flash", &[200, 200, 200, 200, 200, 1000]),
    ("quadruple flash", &[200, 200, 200, 200, 200, 200, 200, 1000]),
];

/// How long the picture of a pattern is, in milliseconds, and how many of these are a unit of it.
const SHOWN: usize = 2400;
const SCALE: usize = 12;

/// The lights with their patterns, as far as the words for these are known; they blink until the reader stops them.
pub(super) fn list(lights: &[Light]) -> String {
    let mut out = String::from(
        "<div class=\"lights\">\n<label><input type=\"checkbox\" checked> Let them blink, in the times of ETG.1300</label>\n",
    );
    for light in lights {
        let patterns: Vec<String> = light.patterns.iter().filter_map(|one| pattern(light, one)).collect();
        if !patterns.is_empty() {
            let name = HtmlEscape(&light.name);
            let _ = writeln!(out, "<p><strong>{name}</strong></p>\n<ul>\n{}</ul>", patterns.concat());
        }
    }
    out + "</div>\n"
}

/// A pattern, if it is known: the light, when it is on, and what that means.
fn pattern(light: &Light, (shows, means): &(String, String)) -> Option<String> {
    let words = shows.to_lowercase();
    let (name, times) = PATTERNS.iter().find(|(name, _)| {
        words.strip_prefix(name).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    })?;
    let class = name.replace(' ', "-");
    let mut bars = String::new();
    for (from, until) in lit(times) {
        let (x, width) = (28 + from / SCALE, (until - from) / SCALE);
        let _ = write!(bars, "<rect x=\"{x}\" y=\"3\" width=\"{}\" height=\"14\"/>", width.max(2));
    }
    Some(format!(
        "<li><svg class=\"light {class} {}\" viewBox=\"0 0 230 20\" width=\"230\" aria-hidden=\"true\">\
         <path d=\"M28 17H228\"/>{bars}<circle cx=\"10\" cy=\"10\" r=\"8\"/></svg> {}: {}</li>\n",
        colour(light.colour.as_deref()),
        HtmlEscape(shows),
        HtmlEscape(means)
    ))
}

/// From when to when a light is on, in the time that is shown.
fn lit(times: &[usize]) -> Vec<(usize, usize)> {
    let mut lit = Vec::new();
    let mut at = 0;
    for (turn, time) in times.iter().cycle().enumerate() {
        if at >= SHOWN {
            break;
        }
        // the times of a pattern are in pairs, so that a light is on in every other
        if turn.is_multiple_of(2) {
            lit.push((at, (at + time).min(SHOWN)));
        }
        at += time;
    }
    lit
}

/// The colour that a description names, if the style knows it.
fn colour(name: Option<&str>) -> &'static str {
    let name = name.unwrap_or_default().to_lowercase();
    let known = ["red", "green", "yellow", "amber", "orange", "blue"];
    known.into_iter().find(|colour| name.contains(colour)).unwrap_or("plain")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_double_flash_is_on_twice_and_then_dark_for_a_second() {
        let [.., (_, times), _, _] = &PATTERNS;
        assert_eq!(lit(times), [(0, 200), (400, 600), (1600, 1800), (2000, 2200)]);
    }

    #[test]
    fn only_patterns_that_are_known_are_drawn() {
        let light = Light { name: "RUN".into(), colour: Some("Green".into()), patterns: Vec::new() };
        let drawn = |shows: &str| pattern(&light, &(shows.to_owned(), "means".to_owned()));
        assert!(
            drawn("blinking (2.5 Hz)").is_some_and(|drawn| drawn.contains("class=\"light blinking green\""))
        );
        assert_eq!(drawn("once in a while"), None);
        assert_eq!(drawn("only at night"), None);
    }
}
