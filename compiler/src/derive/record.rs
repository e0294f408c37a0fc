//! Reading a struct with named fields, as the user wrote it.

use std::iter::Peekable;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use super::Fault;

/// A struct with named fields and without generics.
#[derive(Debug)]
pub(super) struct Record {
    /// The content of each attribute of the name asked for.
    pub(super) attributes: Vec<TokenStream>,
    /// `pub` or less.
    pub(super) visibility: TokenStream,
    pub(super) name: Ident,
    pub(super) fields: Vec<Field>,
}

/// A field of it.
#[derive(Debug)]
pub(super) struct Field {
    /// The content of each attribute of the name asked for.
    pub(super) attributes: Vec<TokenStream>,
    pub(super) name: Ident,
    pub(super) content: TokenStream,
}

impl Field {
    /// The element and the number, if the field is an array.
    pub(super) fn array(&self) -> Option<(TokenStream, TokenStream)> {
        let mut tokens = self.content.clone().into_iter();
        let (Some(TokenTree::Group(group)), None) = (tokens.next(), tokens.next()) else { return None };
        if group.delimiter() != Delimiter::Bracket {
            return None;
        }
        let mut element = TokenStream::new();
        let mut tokens = group.stream().into_iter();
        for token in tokens.by_ref() {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == ';' => {
                    return Some((element, tokens.collect()));
                }
                token => element.extend([token]),
            }
        }
        None
    }

    /// Where its type is written.
    pub(super) fn span(&self) -> Span {
        self.content.clone().into_iter().next().map_or_else(|| self.name.span(), |token| token.span())
    }
}

impl Record {
    /// Reads a struct; `attribute` is the name of the attributes that are kept, `example` one for the message.
    pub(super) fn parse(tokens: TokenStream, attribute: &str, example: &str) -> Result<Self, Fault> {
        let mut tokens = tokens.into_iter().peekable();
        let attributes = attributes(&mut tokens, attribute)?;
        let visibility = visibility(&mut tokens);
        let (keyword, name, body) = (tokens.next(), tokens.next(), tokens.next());
        match (keyword, name, body) {
            (Some(TokenTree::Ident(keyword)), Some(TokenTree::Ident(name)), Some(TokenTree::Group(body)))
                if keyword == "struct" && body.delimiter() == Delimiter::Brace =>
            {
                let fields = fields(body.stream(), attribute)?;
                Ok(Self { attributes, visibility, name, fields })
            }
            (keyword, name, _) => {
                let span = name.or(keyword).map_or_else(Span::call_site, |token| token.span());
                let message =
                    format!("expected a struct with named fields and no generics, such as `{example}`");
                Err(Fault::new(span, message))
            }
        }
    }
}

type Tokens = Peekable<proc_macro2::token_stream::IntoIter>;

/// The attributes ahead, of which those of the name are kept.
fn attributes(tokens: &mut Tokens, name: &str) -> Result<Vec<TokenStream>, Fault> {
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

fn visibility(tokens: &mut Tokens) -> TokenStream {
    let is_word = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "pub");
    let is_scope = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis);
    let word = tokens.next_if(is_word);
    let scope = word.as_ref().and_then(|_| tokens.next_if(is_scope));
    word.into_iter().chain(scope).collect()
}

fn fields(body: TokenStream, attribute: &str) -> Result<Vec<Field>, Fault> {
    let mut tokens = body.into_iter().peekable();
    let mut fields = Vec::new();
    while tokens.peek().is_some() {
        let attributes = attributes(&mut tokens, attribute)?;
        visibility(&mut tokens);
        let name = match (tokens.next(), tokens.next()) {
            (Some(TokenTree::Ident(name)), Some(TokenTree::Punct(colon))) if colon.as_char() == ':' => name,
            (token, _) => {
                let span = token.map_or_else(Span::call_site, |token| token.span());
                return Err(Fault::new(span, "expected a field with a name"));
            }
        };
        fields.push(Field { attributes, name, content: content(&mut tokens) });
    }
    Ok(fields)
}

/// A type: all up to the comma that is not within `<` and `>`.
fn content(tokens: &mut Tokens) -> TokenStream {
    let mut content = TokenStream::new();
    let (mut depth, mut before) = (0_u32, ' ');
    for token in tokens {
        let punct = if let TokenTree::Punct(punct) = &token { punct.as_char() } else { ' ' };
        match punct {
            ',' if depth == 0 => break,
            '<' => depth += 1,
            // the arrow of a function's type is none
            '>' if before != '-' => depth = depth.saturating_sub(1),
            _ => {}
        }
        before = punct;
        content.extend([token]);
    }
    content
}
