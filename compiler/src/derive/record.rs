//! Reading a struct with named fields, as the user wrote it.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use super::Fault;
use super::item::{Form, Item, Tokens, attributes, visibility};

/// A struct with named fields and without generics.
#[derive(Debug)]
pub(super) struct Record {
    /// The content of each attribute of the derive.
    pub(super) attributes: Vec<TokenStream>,
    /// `pub` or less.
    pub(super) visibility: TokenStream,
    pub(super) name: Ident,
    pub(super) fields: Vec<Field>,
}

/// A field of it.
#[derive(Debug)]
pub(super) struct Field {
    /// The content of each attribute of the derive.
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
    pub(super) fn parse(tokens: TokenStream, form: &Form) -> Result<Self, Fault> {
        let Item { attributes, visibility, name, body } = Item::parse(tokens, form)?;
        match body {
            TokenTree::Group(body) if body.delimiter() == Delimiter::Brace => {
                let fields = fields(body.stream(), form)?;
                Ok(Self { attributes, visibility, name, fields })
            }
            _ => Err(Fault::new(name.span(), form.expected)),
        }
    }
}

fn fields(body: TokenStream, form: &Form) -> Result<Vec<Field>, Fault> {
    let mut tokens = body.into_iter().peekable();
    let mut fields = Vec::new();
    while tokens.peek().is_some() {
        let attributes = attributes(&mut tokens, form)?;
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
