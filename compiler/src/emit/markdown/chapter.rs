//! What all chapters have in common.

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;

use super::context::Context;

/// What a chapter shows.
pub(super) trait Chapter: Serialize + Sized {
    /// The parts of a device that it is about.
    type Parts<'d>;

    /// The word for it in links.
    const ID: &'static str;
    /// Its heading.
    const TITLE: &'static str;
    /// Its template.
    const TEMPLATE: &'static str;

    /// What there is to show, if there is anything.
    fn view(context: &Context<'_>, parts: Self::Parts<'_>) -> Option<Self>;

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
    pub(super) title: &'static str,
    pub(super) anchor: &'static str,
    pub(super) sections: Vec<Section>,
    pub(super) template: &'static str,
    pub(super) view: Value,
}

/// Makes the view of a chapter, if there is anything to show.
pub(super) fn prepare<C: Chapter>(context: &Context<'_>, parts: C::Parts<'_>) -> Option<Prepared> {
    let view = C::view(context, parts)?;
    Some(Prepared {
        title: C::TITLE,
        anchor: C::ID,
        sections: view.sections(),
        template: C::TEMPLATE,
        view: Value::from(Serde(view)),
    })
}
