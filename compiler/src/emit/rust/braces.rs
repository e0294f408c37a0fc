//! What is in braces.

use proc_macro2::{Delimiter, Group, TokenStream};

/// Items in braces. Where `quote!` would copy every token of them, they are moved, and the whole is shared from then on.
pub(super) fn braces(items: impl IntoIterator<Item = TokenStream>) -> Group {
    Group::new(Delimiter::Brace, items.into_iter().collect())
}
