//! The homing methods.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{anchor, code, list, sentence, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{HomingMethod, Way};

/// The methods of homing, and what the drive does for each.
pub(super) fn page(context: &Context<'_>, methods: &[HomingMethod]) -> Page {
    let mut page = Page::default();
    page.table(table(context, methods));
    methods.iter().for_each(|method| steps(context, method, &mut page));
    page
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
            list(parameters.iter().map(|name| context.parameter(name))),
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

/// What the drive does for a method, in each case.
fn steps(context: &Context<'_>, method: &HomingMethod, page: &mut Page) {
    if method.steps.is_empty() && method.alternatives.is_empty() {
        return;
    }
    let prose = |steps: &[String]| steps.iter().map(|step| context.prose(step)).collect::<Vec<_>>();
    page.heading(4, format!("{} {}", method.number, text(&method.name)));
    page.steps(&prose(&method.steps));
    for case in method.alternatives.iter().filter(|case| !case.steps.is_empty()) {
        page.text(format!("{}:", opening(&context.prose(&case.when))));
        page.steps(&prose(&case.steps));
    }
}

/// The words that lead up to a list, with a capital at their front.
fn opening(words: &str) -> String {
    sentence(words).trim_end_matches('.').to_owned()
}
