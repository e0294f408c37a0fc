//! The homing methods.

use serde::Serialize;

use crate::emit::markdown::chapter::Chapter;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{anchor, code, list, sentence, text};
use crate::emit::markdown::table::Table;
use crate::model::{HomingMethod, Way};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    methods: Table,
    steps: Vec<StepsView>,
}

/// What the drive does for a method, in each case.
#[derive(Serialize)]
struct StepsView {
    title: String,
    cases: Vec<CaseView>,
}

#[derive(Serialize)]
struct CaseView {
    when: String,
    steps: Vec<String>,
}

impl Chapter for View {
    type Parts<'d> = &'d [HomingMethod];

    const ID: &'static str = "homing";
    const TITLE: &'static str = "Homing methods";
    const TEMPLATE: &'static str = include_str!("../templates/homing.md.j2");

    fn view(context: &Context<'_>, methods: Self::Parts<'_>) -> Option<Self> {
        let told =
            methods.iter().filter(|method| !method.steps.is_empty() || !method.alternatives.is_empty());
        (!methods.is_empty()).then(|| Self {
            methods: table(context, methods),
            steps: told.map(|method| steps(context, method)).collect(),
        })
    }
}

fn table(context: &Context<'_>, methods: &[HomingMethod]) -> Table {
    let titles = [
        "No.",
        "Method",
        "Vendor's name",
        "Starts",
        "Looks for",
        "Index pulse",
        "Parameters",
        "Notes",
        "Source",
    ];
    Table::of(titles, methods, |one| {
        // The steps follow the table.
        let HomingMethod {
            number,
            aliases,
            id: _,
            name,
            method,
            direction,
            pulse,
            target,
            parameters,
            steps: _,
            alternatives: _,
            about,
            source,
            origin,
        } = one;
        let numbers = [*number].into_iter().chain(aliases.iter().copied());
        let id = format!("homing-{number}");
        [
            format!("{}{}", anchor(id), list(numbers.map(code))),
            format!("**{}**", text(name)),
            method.as_deref().map_or(String::new(), text),
            direction.map_or("", way).into(),
            context.optional(target.as_deref()),
            if *pulse { "✓".into() } else { String::new() },
            list(parameters.iter().map(code)),
            context.optional(about.as_deref()),
            context.said(source.as_ref(), origin),
        ]
    })
}

fn way(way: Way) -> &'static str {
    match way {
        Way::Positive => "positive",
        Way::Negative => "negative",
    }
}

fn steps(context: &Context<'_>, method: &HomingMethod) -> StepsView {
    let prose = |steps: &[String]| steps.iter().map(|step| context.prose(step)).collect();
    let main = CaseView { when: String::new(), steps: prose(&method.steps) };
    let others = method.alternatives.iter();
    let others =
        others.map(|one| CaseView { when: opening(&context.prose(&one.when)), steps: prose(&one.steps) });
    StepsView {
        title: format!("{} {}", method.number, text(&method.name)),
        cases: [main].into_iter().chain(others).filter(|one| !one.steps.is_empty()).collect(),
    }
}

/// The words that lead up to a list, with a capital at their front.
fn opening(words: &str) -> String {
    sentence(words).trim_end_matches('.').to_owned()
}
