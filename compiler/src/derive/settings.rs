//! The settings in attributes: `key = value` or a key alone, with commas between.

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::discouraged::Speculative;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Error, Expr, ExprLit, Lit, LitStr, Path, Result, Token};

use super::errors::all;
use super::expression::{bare, check_end, expression, number, text, up_to_comma};
use crate::emit::rust::Options;

/// What there is to say in an attribute.
pub(super) struct Vocabulary {
    /// The name of the attribute.
    pub(super) attribute: &'static str,
    /// The keys that there are.
    pub(super) keys: &'static [&'static str],
    /// Whether an entry may stand beside the settings.
    pub(super) takes_entry: bool,
}

/// What the attributes of an item say: settings, each of which may be there once.
#[derive(Default)]
pub(super) struct Settings {
    settings: Vec<(Ident, Option<Expr>)>,
    /// What stands beside them.
    pub(super) entry: Option<Expr>,
}

impl Settings {
    pub(super) fn parse(attributes: &[Attribute], vocabulary: &Vocabulary) -> Result<Self> {
        let (mut settings, mut pieces) = (Self::default(), Vec::new());
        for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident(vocabulary.attribute))
        {
            let whole = attribute.parse_args_with(|input: ParseStream<'_>| {
                while !input.is_empty() {
                    pieces.push(settings.piece(input, vocabulary).and_then(|()| check_end(input)));
                    up_to_comma(input)?;
                    input.parse::<Option<Token![,]>>()?;
                }
                Ok(())
            });
            pieces.push(whole);
        }
        all(pieces).map(|_| settings)
    }

    /// Reads what is in front of the next comma.
    fn piece(&mut self, input: ParseStream<'_>, vocabulary: &Vocabulary) -> Result<()> {
        match vocabulary.key(input) {
            Some(key) => self.setting(key, input, vocabulary),
            None => self.other(expression(input)?, vocabulary),
        }
    }

    /// Reads what is behind a key.
    fn setting(&mut self, key: Ident, input: ParseStream<'_>, vocabulary: &Vocabulary) -> Result<()> {
        let is_set = input.parse::<Option<Token![=]>>()?.is_some();
        let value = is_set.then(|| expression(input)).transpose()?;
        if !vocabulary.knows(&key) {
            return Err(vocabulary.unknown(&key));
        }
        if self.find(&key.to_string()).is_some() {
            return Err(Error::new(key.span(), format!("`{key}` is set twice")));
        }
        self.settings.push((key, value));
        Ok(())
    }

    /// Takes what is no setting.
    fn other(&mut self, other: Expr, vocabulary: &Vocabulary) -> Result<()> {
        if !vocabulary.takes_entry {
            return Err(vocabulary.unknown(&other));
        }
        if self.entry.is_some() {
            return Err(Error::new_spanned(other, "an entry is named already"));
        }
        self.entry = Some(other);
        Ok(())
    }

    fn find(&self, key: &str) -> Option<&(Ident, Option<Expr>)> {
        self.settings.iter().find(|(known, _)| known == key)
    }

    /// Whether a key is there that takes no value.
    pub(super) fn flag(&self, key: &str) -> Result<bool> {
        match self.find(key) {
            Some((_, Some(value))) => Err(Error::new_spanned(value, format!("`{key}` takes no value"))),
            found => Ok(found.is_some()),
        }
    }

    /// What a key is set to.
    pub(super) fn value(&self, key: &str) -> Result<Option<&Expr>> {
        match self.find(key) {
            Some((key, None)) => Err(Error::new(key.span(), format!("expected `{key} = ..`"))),
            found => Ok(found.and_then(|(_, value)| value.as_ref())),
        }
    }

    /// The text that a key is set to.
    pub(super) fn text(&self, key: &str) -> Result<Option<&LitStr>> {
        let Some(value) = self.value(key)? else { return Ok(None) };
        let expected = || Error::new_spanned(value, format!("expected `{key} = \"..\"`, a plain text"));
        text(value).map(Some).ok_or_else(expected)
    }

    /// Whether a key is set to `true`; none if it is not set.
    pub(super) fn choice(&self, key: &str) -> Result<Option<bool>> {
        let Some(value) = self.value(key)? else { return Ok(None) };
        match bare(value) {
            Expr::Lit(ExprLit { lit: Lit::Bool(choice), .. }) => Ok(Some(choice.value)),
            _ => Err(Error::new_spanned(value, format!("expected `{key} = true` or `{key} = false`"))),
        }
    }

    /// The number that a key is set to.
    pub(super) fn number(&self, key: &str, of: &str) -> Result<Option<u8>> {
        self.value(key)?.map(|value| number(value, of)).transpose()
    }

    /// The name that a key is set to, as it is or as a text; `what` says of what.
    pub(super) fn name<P: Parser>(&self, key: &str, parser: P, what: &str) -> Result<Option<P::Output>> {
        let Some(value) = self.value(key)? else { return Ok(None) };
        let (written, name) = match text(value) {
            Some(text) => (text.value(), text.parse_with(parser)),
            None => {
                let tokens = bare(value).to_token_stream();
                (tokens.to_string(), parser.parse2(tokens))
            }
        };
        name.map(Some).map_err(|_| Error::new_spanned(value, format!("`{written}` is no {what}")))
    }

    /// The path of the runtime crate.
    pub(super) fn runtime(&self) -> Result<TokenStream> {
        let path = self.name("runtime", Path::parse_mod_style, "path of a crate or module")?;
        Ok(path.map_or_else(|| Options::default().runtime, Path::into_token_stream))
    }
}

impl Vocabulary {
    fn knows(&self, key: &Ident) -> bool {
        self.keys.iter().any(|known| key == known)
    }

    /// Takes the key of a setting: it is before a `=`, or known and alone.
    fn key(&self, input: ParseStream<'_>) -> Option<Ident> {
        let ahead = input.fork();
        let key = ahead.call(Ident::parse_any).ok()?;
        let is_set = ahead.peek(Token![=]) && !ahead.peek(Token![==]);
        let is_alone = ahead.is_empty() || ahead.peek(Token![,]) || ahead.peek(Lit);
        (is_set || is_alone && self.knows(&key)).then(|| {
            input.advance_to(&ahead);
            key
        })
    }

    fn unknown(&self, found: &impl ToTokens) -> Error {
        let keys: Vec<String> = self.keys.iter().map(|key| format!("`{key}`")).collect();
        let found = found.to_token_stream();
        let message = format!("there is no setting `{found}`, but {}", keys.join(", "));
        Error::new_spanned(found, message)
    }
}
