//! Reading a struct as the user wrote it. It is little enough to do without a parser of Rust, which would take longer
//! to build than all the rest.

use std::iter::Peekable;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use super::Fault;

/// What a derive takes.
#[derive(Debug)]
pub(super) struct Form {
    /// The name of its attributes.
    pub(super) attribute: &'static str,
    /// What it expects, with an example.
    pub(super) expected: &'static str,
}

/// A struct without generics.
#[derive(Debug)]
pub(super) struct Item {
    /// The content of each attribute of the derive.
    pub(super) attributes: Vec<TokenStream>,
    /// `pub` or less.
    pub(super) visibility: TokenStream,
    pub(super) name: Ident,
    /// What is behind the name: fields between braces, or a semicolon.
    pub(super) body: TokenTree,
}

pub(super) type Tokens = Peekable<proc_macro2::token_stream::IntoIter>;

impl Item {
    pub(super) fn parse(tokens: TokenStream, form: &Form) -> Result<Self, Fault> {
        let mut tokens = tokens.into_iter().peekable();
        let attributes = attributes(&mut tokens, form)?;
        let visibility = visibility(&mut tokens);
        match (tokens.next(), tokens.next(), tokens.next()) {
            (Some(TokenTree::Ident(keyword)), Some(TokenTree::Ident(name)), Some(body))
                if keyword == "struct" =>
            {
                Ok(Self { attributes, visibility, name, body })
            }
            (keyword, name, _) => {
                let span = name.or(keyword).map_or_else(Span::call_site, |token| token.span());
                Err(Fault::new(span, form.expected))
            }
        }
    }
}

/// The attributes ahead, of which those of the derive are kept.
pub(super) fn attributes(tokens: &mut Tokens, form: &Form) -> Result<Vec<TokenStream>, Fault> {
    let name = form.attribute;
    let mut kept = Vec::new();
    while let Some(TokenTree::Punct(_)) = tokens.peek() {
        tokens.next();
        let Some(TokenTree::Group(attribute)) = tokens.next() else { continue };
        let mut content = attribute.stream().into_iter();
        match (content.next(), content.next()) {
            (Some(TokenTree::Ident(word)), Some(TokenTree::Group(list))) if word == name => {
                kept.push(list.stream());
            }
            (Some(TokenTree::Ident(word)), _) if word == name => {
                return Err(Fault::new(word.span(), format!("expected `{name}(..)`")));
            }
            _ => {}
        }
    }
    Ok(kept)
}

/// `pub`, `pub(..)` or nothing.
pub(super) fn visibility(tokens: &mut Tokens) -> TokenStream {
    let is_word = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "pub");
    let is_scope = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis);
    let word = tokens.next_if(is_word);
    let scope = word.as_ref().and_then(|_| tokens.next_if(is_scope));
    word.into_iter().chain(scope).collect()
}
