//! Where the facts are from, and how sure they are.

use crate::emit::markdown::context::{Context, assumption_id, erratum_id};
use crate::emit::markdown::inline::{anchor, code, sentence, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Assumption, Document, Erratum, Remark, RemarkKind, Said};

/// Where the facts are from, and how sure they are.
pub(super) fn page(
    context: &Context<'_>,
    documents: &[Document],
    errata: &[Erratum],
    remarks: &[Remark],
    assumptions: &[Assumption],
) -> Page {
    let mut page = Page::default();
    page.table(document_table(context, documents));
    let lists = [documents.len(), errata.len(), remarks.len(), assumptions.len()];
    if !context.editorial || lists.iter().all(|length| *length == 0) {
        return page;
    }
    page.lines(MARKS.to_owned());
    if !errata.is_empty() {
        page.heading(3, "Errata");
        page.text("Where the sources contradict themselves, and what holds.");
        page.list(errata.iter().map(|erratum| self::erratum(context, erratum)));
    }
    page.titled("Remarks", remark_table(context, remarks));
    if !assumptions.is_empty() {
        page.heading(3, "Assumptions");
        page.text("What no source states, and what is taken to be so.");
        page.table(assumption_table(context, assumptions));
    }
    page
}

/// What the words and marks beside a source mean.
const MARKS: &str = "\
Beside a source stands what it does not state: *profile* names what a standard profile says, *assumed* what no source says,
*corrected* and *contradicted* what the source says and an erratum answers. In tables † stands for the profile and ‡ for an
assumption.";

fn document_table(context: &Context<'_>, documents: &[Document]) -> Table {
    let titles = ["Document", "Number", "Edition", "Publisher", "Use"];
    Table::of(titles, documents, |document| {
        let Document { id, title, number, edition, publisher, about, source: _, origin } = document;
        let marked = |told: String, key: &str| match told.is_empty() {
            true => told,
            false => told + &context.mark(origin, key),
        };
        let optional =
            |plain: &Option<String>, key: &str| marked(plain.as_deref().map_or(String::new(), text), key);
        [
            marked(format!("{}{}", anchor(format!("doc-{id}")), text(title)), "title"),
            optional(number, "number"),
            optional(edition, "edition"),
            optional(publisher, "publisher"),
            marked(context.optional(about.as_deref()), "about"),
        ]
    })
}

fn erratum(context: &Context<'_>, erratum: &Erratum) -> String {
    let (at, rule) = (context.prose(&erratum.at.to_string()), code(&erratum.rule));
    let (says, holds) = (says(context, erratum), holds(context, erratum));
    let why = sentence(&context.prose(&erratum.why));
    let line = format!(
        "{}**{at}** ({rule}). *The source says:* {says} *What holds:* {holds} *Why:* {why} {}",
        anchor(erratum_id(erratum)),
        context.source_line(erratum.source.as_ref())
    );
    line.trim_end().to_owned()
}

/// What is so, if anybody knows.
fn holds(context: &Context<'_>, erratum: &Erratum) -> String {
    match (&erratum.holds, erratum.stands) {
        (Some(Said::Keys(keys)), _) if keys.is_empty() => "Nothing of it.".into(),
        (Some(holds), _) => sentence(&context.prose(&holds.to_string())),
        (None, true) => "What it says.".into(),
        (None, false) => "Nobody knows.".into(),
    }
}

/// What the source says, if it says anything.
fn says(context: &Context<'_>, erratum: &Erratum) -> String {
    match &erratum.says {
        Said::Keys(keys) if keys.is_empty() => "Nothing.".into(),
        says => sentence(&context.prose(&says.to_string())),
    }
}

fn remark_table(context: &Context<'_>, remarks: &[Remark]) -> Table {
    Table::of(["About", "Kind", "Notes", "Source"], remarks, |remark| {
        [
            context.prose(&remark.at.to_string()),
            kind(remark.kind).into(),
            context.prose(&remark.text),
            context.source(remark.source.as_ref()),
        ]
    })
}

fn kind(kind: RemarkKind) -> &'static str {
    match kind {
        RemarkKind::Contradiction => "contradiction",
        RemarkKind::Silence => "silence",
        RemarkKind::Doubt => "doubt",
    }
}

fn assumption_table(context: &Context<'_>, assumptions: &[Assumption]) -> Table {
    Table::of(["About", "Taken to be", "Why"], assumptions, |assumption| {
        let value = assumption.value.as_ref().map_or(String::new(), code);
        let at =
            format!("{}{}", anchor(assumption_id(assumption)), context.prose(&assumption.at.to_string()));
        [at, value, context.prose(&assumption.reason)]
    })
}
