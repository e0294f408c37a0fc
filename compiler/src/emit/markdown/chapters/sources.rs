//! Where the facts are from, and how sure they are.

use serde::Serialize;

use crate::emit::markdown::chapter::Chapter;
use crate::emit::markdown::context::{Context, assumption_id, erratum_id};
use crate::emit::markdown::inline::{anchor, code, sentence, text};
use crate::emit::markdown::table::Table;
use crate::model::{Assumption, Document, Erratum, Remark, RemarkKind, Said};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    editorial: bool,
    documents: Table,
    errata: Vec<ErratumView>,
    remarks: Table,
    assumptions: Table,
}

#[derive(Serialize)]
struct ErratumView {
    anchor: String,
    at: String,
    says: String,
    holds: String,
    why: String,
    rule: String,
    source: String,
}

impl Chapter for View {
    type Parts<'d> = (&'d [Document], &'d [Erratum], &'d [Remark], &'d [Assumption]);

    const ID: &'static str = "sources";
    const TITLE: &'static str = "Sources";
    const TEMPLATE: &'static str = include_str!("../templates/sources.md.j2");

    fn view(
        context: &Context<'_>,
        (documents, errata, remarks, assumptions): Self::Parts<'_>,
    ) -> Option<Self> {
        let editorial = context.editorial;
        let errata = if editorial { errata } else { &[] };
        let remarks = if editorial { remarks } else { &[] };
        let assumptions = if editorial { assumptions } else { &[] };
        let lists = [documents.len(), errata.len(), remarks.len(), assumptions.len()];
        (lists.iter().sum::<usize>() > 0).then(|| Self {
            editorial,
            documents: document_table(context, documents),
            errata: errata.iter().map(|erratum| erratum_view(context, erratum)).collect(),
            remarks: remark_table(context, remarks),
            assumptions: assumption_table(context, assumptions),
        })
    }
}

fn document_table(context: &Context<'_>, documents: &[Document]) -> Table {
    let titles = ["Document", "Number", "Edition", "Publisher", "Use"];
    Table::of(titles, documents, |document| {
        let optional = |plain: &Option<String>| plain.as_deref().map_or(String::new(), text);
        [
            format!("{}{}", anchor(format!("doc-{}", document.id)), text(&document.title)),
            optional(&document.number),
            optional(&document.edition),
            optional(&document.publisher),
            context.optional(document.about.as_deref()),
        ]
    })
}

fn erratum_view(context: &Context<'_>, erratum: &Erratum) -> ErratumView {
    ErratumView {
        at: context.prose(&erratum.at.to_string()),
        says: says(context, erratum),
        holds: holds(context, erratum),
        why: sentence(&context.prose(&erratum.why)),
        rule: code(&erratum.rule),
        anchor: anchor(erratum_id(erratum)),
        source: context.source_line(erratum.source.as_ref()),
    }
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
