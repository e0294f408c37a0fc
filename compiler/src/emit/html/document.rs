//! The page as a whole.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, HtmlEscape, context};
use pulldown_cmark::{Options, Parser, html::push_html};
use serde::Serialize;
use sha2::{Digest, Sha256};

use super::data::Data;
use super::figure::svg;
use super::ways::{Step, Way, ways};
use crate::emit::escape::comment;
use crate::emit::markdown::{Block, Heading, Page, body, front};
use crate::emit::template;
use crate::model::Family;
use crate::text::characters::{json, line};

const PAGE: &str = include_str!("templates/page.html.j2");
const STYLE: &str = include_str!("templates/style.css");
const SCRIPT: &str = include_str!("templates/script.js");

/// A line of the navigation.
#[derive(Debug, Serialize)]
struct Place {
    level: usize,
    anchor: String,
    title: String,
}

/// The ways into operation, and which members they are of; none if they are of all.
#[derive(Debug, Serialize)]
struct Ways {
    members: String,
    ways: Vec<WayView>,
}

#[derive(Debug, Serialize)]
struct WayView {
    from: String,
    steps: Vec<String>,
}

/// The whole page.
pub(super) fn document(family: &Family, editorial: bool) -> String {
    let body = body(family, editorial, false);
    let view = context! {
        id => comment(&line(&family.id)),
        name => family.name.clone(),
        style => STYLE,
        style_hash => hash(STYLE),
        script => SCRIPT,
        script_hash => hash(SCRIPT),
        places => Serde(places(&body)),
        front => html(&front(family), &family.name),
        body => html(&body, &family.name),
        ways => Serde(ways_of(family)),
        data => data(family),
    };
    let escape = |environment: &mut Environment<'static>| {
        environment.set_auto_escape_callback(|_| AutoEscape::Html);
    };
    template::render("page.html", PAGE, escape, view)
}

/// The hash by which the policy of the page lets a text be run.
fn hash(text: &str) -> String {
    format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(text)))
}

/// The facts for the script, as an element of HTML can hold them.
fn data(family: &Family) -> String {
    // fails only for keys that are not text
    let text = serde_json::to_string(&Data::of(family)).unwrap_or_default();
    json(&text).replace('<', "\\u003c")
}

/// The chapters and their parts.
fn places(page: &Page) -> Vec<Place> {
    let place = |block: &Block| match block {
        Block::Heading(Heading { level: level @ (2 | 3), anchor: Some(anchor), title }) => {
            Some(Place { level: *level, anchor: anchor.clone(), title: plain(title) })
        }
        _ => None,
    };
    page.0.iter().filter_map(place).collect()
}

/// Blocks as HTML.
fn html(page: &Page, name: &str) -> String {
    let mut out = String::new();
    for block in &page.0 {
        match block {
            Block::Heading(Heading { level, anchor, title }) => {
                let id =
                    anchor.as_ref().map_or(String::new(), |anchor| format!(" id=\"{}\"", HtmlEscape(anchor)));
                out.push_str(&format!("<h{level}{id}>{}</h{level}>\n", inline(title)));
            }
            Block::Machine(machine) => out.push_str(&svg(machine, &format!("The states of {name}"))),
            Block::Table(table) => {
                // a wide one moves by itself, and not the page
                out.push_str("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"table\">\n");
                markdown(&table.to_string(), &mut out);
                out.push_str("</div>\n");
            }
            other => markdown(&other.to_string(), &mut out),
        }
    }
    out
}

fn markdown(text: &str, out: &mut String) {
    push_html(out, Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_GFM));
}

/// What stands in a line, without a paragraph around it.
fn inline(text: &str) -> String {
    let mut out = String::new();
    markdown(text, &mut out);
    let inner = out.trim().strip_prefix("<p>").and_then(|inner| inner.strip_suffix("</p>"));
    inner.map_or_else(|| HtmlEscape(text).to_string(), str::to_owned)
}

/// The words of a title, without what makes them look like something.
fn plain(title: &str) -> String {
    let texts = Parser::new(title).filter_map(|event| match event {
        pulldown_cmark::Event::Text(text) | pulldown_cmark::Event::Code(text) => Some(text.into_string()),
        _ => None,
    });
    texts.collect()
}

/// The ways into operation; those of members that have the same stand once.
fn ways_of(family: &Family) -> Vec<Ways> {
    let mut groups: Vec<(Vec<&str>, Vec<Way>)> = Vec::new();
    for device in &family.members {
        let own = ways(device);
        match groups.iter_mut().find(|(_, same)| *same == own) {
            Some((members, _)) => members.push(&device.name),
            None => groups.push((vec![&device.name], own)),
        }
    }
    let all = groups.len() == 1;
    let groups = groups.into_iter().filter(|(_, ways)| !ways.is_empty());
    let view = |(members, ways): (Vec<&str>, Vec<Way>)| Ways {
        members: if all { String::new() } else { members.join(", ") },
        ways: ways.iter().map(way_view).collect(),
    };
    groups.map(view).collect()
}

fn way_view(way: &Way) -> WayView {
    let step = |step: &Step| match &step.word {
        None => format!("wait for {}", step.to),
        Some((word, name)) if step.rising == 0 => format!("0x{word:04X} ({name}): {}", step.to),
        Some((word, name)) => {
            format!("0x{:04X}, then 0x{word:04X} ({name}): {}", word & !step.rising, step.to)
        }
    };
    WayView { from: way.from.clone(), steps: way.steps.iter().map(step).collect() }
}
