//! The settings in attributes: `key = value` or a key alone, with commas between.

use proc_macro2::{Ident, TokenStream, TokenTree};

use super::Fault;
use crate::emit::rust::Options;

/// The settings of an item, each of which may be there once.
#[derive(Debug)]
pub(super) struct Settings {
    settings: Vec<(Ident, TokenStream)>,
}

impl Settings {
    /// Reads the content of attributes; `known` are the keys that there are.
    pub(super) fn parse(attributes: &[TokenStream], known: &[&str]) -> Result<Self, Fault> {
        let mut settings: Vec<(Ident, TokenStream)> = Vec::new();
        for attribute in attributes {
            let mut tokens = attribute.clone().into_iter().peekable();
            while let Some(token) = tokens.next() {
                let TokenTree::Ident(key) = token else {
                    return Err(Fault::new(token.span(), "expected a setting"));
                };
                if !known.iter().any(|known| key == known) {
                    let known: Vec<String> = known.iter().map(|key| format!("`{key}`")).collect();
                    let message = format!("there is no setting `{key}`, but {}", known.join(", "));
                    return Err(Fault::new(key.span(), message));
                }
                if settings.iter().any(|(other, _)| *other == key) {
                    return Err(Fault::new(key.span(), format!("`{key}` is set twice")));
                }
                settings.push((key, value(&mut tokens)?));
            }
        }
        Ok(Self { settings })
    }

    /// The value of a key; empty if the key stands alone.
    pub(super) fn get(&self, key: &str) -> Option<&TokenStream> {
        self.settings.iter().find(|(known, _)| known == key).map(|(_, value)| value)
    }

    /// The path of the runtime crate.
    pub(super) fn runtime(&self) -> TokenStream {
        self.get("runtime").cloned().unwrap_or_else(default_runtime)
    }
}

/// Where the runtime crate is if nobody says so.
pub(super) fn default_runtime() -> TokenStream {
    Options::default().runtime
}

/// What is between an equals sign and the next comma.
fn value(tokens: &mut impl Iterator<Item = TokenTree>) -> Result<TokenStream, Fault> {
    let is = |token: &TokenTree, mark| matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark);
    match tokens.next() {
        None => Ok(TokenStream::new()),
        Some(token) if is(&token, ',') => Ok(TokenStream::new()),
        Some(token) if is(&token, '=') => Ok(tokens.take_while(|token| !is(token, ',')).collect()),
        Some(token) => Err(Fault::new(token.span(), "expected `=` or a comma")),
    }
}
