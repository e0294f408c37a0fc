//! The settings in attributes: `key = value` or a key alone, with commas between.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

use super::Fault;
use crate::emit::rust::Options;

/// The settings of an item, each of which may be there once.
#[derive(Debug, Default)]
pub(super) struct Settings {
    settings: Vec<(Ident, TokenStream)>,
}

impl Settings {
    /// Reads the content of attributes; `known` are the keys that there are.
    pub(super) fn parse(attributes: &[TokenStream], known: &[&str]) -> Result<Self, Fault> {
        match Self::beside(attributes, known)? {
            (None, settings) => Ok(settings),
            (Some(other), _) => Err(no_setting(other, known)),
        }
    }

    /// The same where something may stand beside them that is no setting.
    pub(super) fn beside(
        attributes: &[TokenStream],
        known: &[&str],
    ) -> Result<(Option<TokenStream>, Self), Fault> {
        let (mut beside, mut settings) = (None, Self::default());
        for piece in attributes.iter().flat_map(pieces) {
            match settings.take(piece, known)? {
                Some(other) if beside.is_some() => return Err(no_setting(other, known)),
                Some(other) => beside = Some(other),
                None => {}
            }
        }
        Ok((beside, settings))
    }

    /// Takes a setting, and gives back what is none.
    fn take(&mut self, piece: TokenStream, known: &[&str]) -> Result<Option<TokenStream>, Fault> {
        let mut tokens = piece.clone().into_iter();
        let (Some(TokenTree::Ident(key)), mark) = (tokens.next(), tokens.next()) else {
            return Ok(Some(piece));
        };
        let is_known = known.iter().any(|known| key == known);
        match mark {
            None if !is_known => Ok(Some(piece)),
            Some(mark) if !is(&mark, '=') => Ok(Some(piece)),
            Some(_) if !is_known => Err(unknown(&key, known)),
            _ if self.find(&key.to_string()).is_some() => {
                Err(Fault::new(key.span(), format!("`{key}` is set twice")))
            }
            _ => {
                self.settings.push((key, tokens.collect()));
                Ok(None)
            }
        }
    }

    fn find(&self, key: &str) -> Option<&(Ident, TokenStream)> {
        self.settings.iter().find(|(known, _)| known == key)
    }

    /// The value of a key; empty if the key stands alone.
    pub(super) fn get(&self, key: &str) -> Option<&TokenStream> {
        self.find(key).map(|(_, value)| value)
    }

    /// The text that a key is set to, and where it is written.
    pub(super) fn text(&self, key: &str) -> Result<Option<(String, Span)>, Fault> {
        let Some((key, value)) = self.find(key) else { return Ok(None) };
        let mut tokens = value.clone().into_iter();
        let token = tokens.next();
        let span = token.as_ref().map_or_else(|| key.span(), TokenTree::span);
        match (token.and_then(|token| unquoted(&token.to_string())), tokens.next()) {
            (Some(text), None) => Ok(Some((text, span))),
            (Some(_), Some(other)) => Err(Fault::new(other.span(), "expected a comma")),
            (None, _) => Err(Fault::new(span, format!("expected `{key} = \"..\"`, a plain text"))),
        }
    }

    /// The number that a key is set to.
    pub(super) fn number(&self, key: &str, of: &str) -> Result<Option<u8>, Fault> {
        let Some((key, value)) = self.find(key) else { return Ok(None) };
        number(value, key.span(), of).map(Some)
    }

    /// The path of the runtime crate, written as a path or as a text.
    pub(super) fn runtime(&self) -> Result<TokenStream, Fault> {
        let Some((key, value)) = self.find("runtime") else { return Ok(Options::default().runtime) };
        let path = match self.text("runtime") {
            Ok(Some((text, _))) => text,
            _ => value.to_string(),
        };
        let is_path = path.trim_start_matches("::").split("::").all(|name| is_identifier(name.trim()));
        match path.parse() {
            Ok(tokens) if is_path => Ok(tokens),
            _ => Err(Fault::new(key.span(), format!("`{path}` is no path of a crate or module"))),
        }
    }
}

/// A number from 1 to 255 in digits; `of` says what is counted.
pub(super) fn number(tokens: &TokenStream, otherwise: Span, of: &str) -> Result<u8, Fault> {
    let mut tokens = tokens.clone().into_iter();
    let (token, rest) = (tokens.next(), tokens.next());
    let span = token.as_ref().map_or(otherwise, TokenTree::span);
    let number = token.and_then(|token| token.to_string().parse().ok()).filter(|_| rest.is_none());
    match number {
        Some(number @ 1..) => Ok(number),
        _ => Err(Fault::new(span, format!("expected the number of {of} in digits, from 1 to 255"))),
    }
}

/// Whether a text can be the name of something.
pub(super) fn is_identifier(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && text != "_"
}

fn is(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// What is between commas.
fn pieces(attribute: &TokenStream) -> Vec<TokenStream> {
    let tokens: Vec<TokenTree> = attribute.clone().into_iter().collect();
    let pieces = tokens.split(|token| is(token, ',')).filter(|piece| !piece.is_empty());
    pieces.map(|piece| piece.iter().cloned().collect()).collect()
}

fn unknown(key: &Ident, known: &[&str]) -> Fault {
    let known: Vec<String> = known.iter().map(|key| format!("`{key}`")).collect();
    Fault::new(key.span(), format!("there is no setting `{key}`, but {}", known.join(", ")))
}

fn no_setting(piece: TokenStream, known: &[&str]) -> Fault {
    let mut tokens = piece.into_iter();
    match (tokens.next(), tokens.next()) {
        (Some(TokenTree::Ident(key)), Some(other)) if known.iter().any(|known| key == known) => {
            Fault::new(other.span(), "expected `=` or a comma")
        }
        (Some(TokenTree::Ident(key)), _) => unknown(&key, known),
        (token, _) => {
            let span = token.map_or_else(Span::call_site, |token| token.span());
            Fault::new(span, "expected a setting")
        }
    }
}

/// The text of a string literal; none if it is another literal, or if it has escapes that no path needs.
fn unquoted(literal: &str) -> Option<String> {
    if let Some(raw) = literal.strip_prefix('r') {
        let raw = raw.trim_matches('#');
        return raw.strip_prefix('"')?.strip_suffix('"').map(str::to_owned);
    }
    let inner = literal.strip_prefix('"')?.strip_suffix('"')?;
    let plain = inner.replace("\\\\", "/").replace("\\\"", "");
    (!plain.contains('\\')).then(|| inner.replace("\\\\", "\\").replace("\\\"", "\""))
}
