//! A family as one document.

use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{Environment, UndefinedBehavior, Value, context};
use serde::Serialize;

use super::chapters::CHAPTERS;
use super::context::Context;
use super::inline::{link, text};
use crate::model::{Device, Family};

const TEMPLATE: &str = include_str!("templates/document.md.j2");

/// What a chapter shows.
pub(super) trait Chapter: Serialize + Sized {
    /// The word for it in links.
    const ID: &'static str;
    /// Its heading.
    const TITLE: &'static str;
    /// Its template.
    const TEMPLATE: &'static str;

    /// What there is to show, if there is anything.
    fn view(context: &Context<'_>) -> Option<Self>;

    /// Its parts that the contents lists.
    fn sections(&self) -> Vec<Section> {
        Vec::new()
    }
}

/// A line of the contents.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Section {
    /// Its heading.
    pub(super) title: String,
    /// Where it is.
    pub(super) anchor: String,
}

/// A chapter ready for its template.
pub(super) struct Prepared {
    title: &'static str,
    anchor: String,
    sections: Vec<Section>,
    template: &'static str,
    view: Value,
}

/// Makes the view of a chapter, if there is anything to show.
pub(super) fn prepare<C: Chapter>(context: &Context<'_>) -> Option<Prepared> {
    let view = C::view(context)?;
    Some(Prepared {
        title: C::TITLE,
        anchor: context.id(C::ID),
        sections: view.sections(),
        template: C::TEMPLATE,
        view: Value::from(Serde(view)),
    })
}

/// The whole document: a part for each member.
pub(super) fn document(family: &Family) -> String {
    let alone = family.members.len() == 1;
    let parts = family.members.iter().map(|device| {
        let prefix = if alone { String::new() } else { format!("{}-", device.id) };
        let part = part(&Context::new(device, prefix));
        // Views and templates are part of devc, and each is rendered by a test: this says where one is broken.
        part.unwrap_or_else(|error| format!("# {}\n\ndevc could not print this: {error:#}\n", device.id))
    });
    let mut parts: Vec<String> = parts.collect();
    if !alone {
        parts.insert(0, overview(family));
    }
    tidy(&format!(
        "<!-- Made by devc from the description of {}; not to be edited. -->\n{}",
        family.id,
        parts.join("\n")
    ))
}

/// What the members of a family share, and where each is described.
fn overview(family: &Family) -> String {
    let members = family.members.iter().map(|device| {
        let title = device.title.as_deref().map_or(String::new(), |title| format!(": {}", text(title)));
        format!("- {}{title}\n", link(text(&device.name), format!("{}-device", device.id)))
    });
    let about = family.about.as_deref().map_or(String::new(), text);
    format!("\n# {}\n\n{about}\n\n{}", text(&family.name), members.collect::<String>())
}

fn part(context: &Context<'_>) -> Result<String, minijinja::Error> {
    let environment = environment()?;
    let prepared: Vec<Prepared> = CHAPTERS.iter().filter_map(|chapter| chapter(context)).collect();
    let mut chapters = Vec::new();
    for Prepared { title, anchor, sections, template, view } in prepared {
        let body = environment.render_named_str(title, template, view)?;
        chapters.push(context! { title, anchor, sections => Serde(sections), body });
    }
    environment.render_named_str("document", TEMPLATE, front(context.device, chapters))
}

fn front(device: &Device, chapters: Vec<Value>) -> Value {
    let optional = |text: &Option<String>| text.as_deref().map_or(String::new(), self::text);
    context! {
        name => text(&device.name),
        title => optional(&device.title),
        main => device.documents.first().map_or(String::new(), |document| text(&document.title)),
        chapters,
    }
}

fn environment() -> Result<Environment<'static>, minijinja::Error> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    Ok(environment)
}

/// Takes out the blank lines that parts left out leave behind.
fn tidy(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut blank = true;
    for line in text.lines().map(str::trim_end) {
        if !(blank && line.is_empty()) {
            out.push_str(line);
            out.push('\n');
        }
        blank = line.is_empty();
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}
