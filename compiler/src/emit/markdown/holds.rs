//! What things hold for, and what they can be chosen by. The page lets its readers choose; Markdown shows none of it.

use std::collections::BTreeSet;
use std::fmt;

/// What a reference is made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::emit) enum Form {
    /// A text, in which all stands that there is.
    Text,
    /// A page, on which a reader chooses.
    Page,
}

/// For which members and on which axes something holds, and what else it can be chosen by. Where nothing is said, for all.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in crate::emit) struct Holds {
    /// The members, by number.
    pub(super) members: Vec<usize>,
    /// The axes, by number.
    pub(super) axes: Vec<u8>,
    /// The words by which it is chosen.
    pub(super) kinds: BTreeSet<&'static str>,
}

impl Holds {
    /// What holds for some members.
    pub(in crate::emit) fn for_members(members: &[usize]) -> Self {
        Self { members: members.to_vec(), ..Self::default() }
    }

    /// What holds on some axes.
    pub(super) fn on_axes(axes: &[u8]) -> Self {
        Self { axes: axes.to_vec(), ..Self::default() }
    }

    /// A text that holds for these only, as the page has it.
    pub(super) fn around(&self, class: &str, text: &str) -> String {
        let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
        format!("<span{class}{self}>{text}</span>")
    }
}

/// As attributes of an element.
impl fmt::Display for Holds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { members, axes, kinds } = self;
        attribute(f, "members", members)?;
        attribute(f, "axes", axes)?;
        attribute(f, "kinds", kinds)
    }
}

fn attribute<T: ToString>(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    items: impl IntoIterator<Item = T>,
) -> fmt::Result {
    let items = items.into_iter().map(|item| item.to_string()).collect::<Vec<_>>();
    if items.is_empty() { Ok(()) } else { write!(f, " data-{name}=\"{}\"", items.join(" ")) }
}
