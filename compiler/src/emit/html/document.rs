//! The page as a whole.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, context};
use serde::Serialize;
use sha2::{Digest, Sha256};

use super::blocks::{html, plain};
use super::data::Data;
use super::sequences::groups;
use crate::emit::escape::comment;
use crate::emit::markdown::{Block, Form, Heading, Page, body, front};
use crate::emit::template;
use crate::model::Family;
use crate::text::characters::{json, line};

const PAGE: &str = include_str!("templates/page.html.j2");
const STYLE: &str = include_str!("templates/style.css");
const SCRIPT: &str = concat!(
    include_str!("templates/script/meanings.js"),
    include_str!("templates/script/decoders.js"),
    include_str!("templates/script/choice.js"),
    include_str!("templates/script/search.js"),
    include_str!("templates/script/begin.js"),
);

/// A line of the navigation.
#[derive(Debug, Serialize)]
struct Place {
    level: usize,
    anchor: String,
    title: String,
    holds: String,
}

/// The whole page.
pub(super) fn document(family: &Family, editorial: bool) -> String {
    let body = body(family, editorial, Form::Page);
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
        groups => Serde(groups(family)),
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
        Block::Heading(Heading { level: level @ (2 | 3), anchor: Some(anchor), title, holds }) => {
            let (anchor, title) = (anchor.clone(), plain(title));
            Some(Place { level: *level, anchor, title, holds: holds.to_string() })
        }
        _ => None,
    };
    page.0.iter().filter_map(place).collect()
}
