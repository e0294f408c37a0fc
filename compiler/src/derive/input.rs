//! Reading what the user wrote: a unit struct with a `device` attribute. It is little enough to do without a parser
//! of Rust, which would take longer to build than all the rest.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use super::settings::default_runtime;
use super::{Fault, module_name};

/// The struct and what its attribute says.
#[derive(Debug)]
pub(super) struct Input {
    /// The struct.
    pub(super) name: Ident,
    /// The description, from the folder of the manifest.
    pub(super) path: String,
    /// Where the path is written.
    pub(super) span: Span,
    /// The path of the runtime crate.
    pub(super) runtime: TokenStream,
    /// The name of the generated module.
    pub(super) module: Ident,
    /// The member of a family.
    pub(super) member: Option<String>,
}

/// The keys of the attribute.
const KEYS: [&str; 4] = ["path", "runtime", "module", "member"];

/// A value of the attribute, with its place.
type Setting = (String, Span);

impl Input {
    pub(super) fn parse(tokens: TokenStream) -> Result<Self, Fault> {
        let mut settings: [Option<Setting>; 4] = Default::default();
        let mut tokens = tokens.into_iter().peekable();
        while let Some(TokenTree::Punct(_)) = tokens.peek() {
            tokens.next();
            if let Some(TokenTree::Group(group)) = tokens.next() {
                read_attribute(group.stream(), &mut settings)?;
            }
        }
        let name = unit_struct(tokens)?;
        let [path, runtime, module, member] = settings;
        let missing = || {
            let example = "#[device(path = \"devices/c887\")]";
            Fault::new(
                name.span(),
                format!("which device is `{name}`? Add `{example}`, a path from the folder of Cargo.toml"),
            )
        };
        let (path, span) = path.ok_or_else(missing)?;
        let module = match module {
            Some((module, span)) => Ident::new(&identifier(module, span)?, span),
            None => module_name(&name),
        };
        Ok(Self {
            runtime: runtime_path(runtime)?,
            module,
            member: member.map(|(id, _)| id),
            name,
            path,
            span,
        })
    }
}

fn runtime_path(setting: Option<Setting>) -> Result<TokenStream, Fault> {
    match setting {
        None => Ok(default_runtime()),
        Some((path, span)) => {
            let is_path = path.trim_start_matches("::").split("::").all(is_identifier);
            match path.parse() {
                Ok(tokens) if is_path => Ok(tokens),
                _ => Err(Fault::new(span, format!("`{path}` is no path of a crate or module"))),
            }
        }
    }
}

fn identifier(text: String, span: Span) -> Result<String, Fault> {
    if is_identifier(&text) {
        Ok(text)
    } else {
        Err(Fault::new(span, format!("`{text}` is no name of a module")))
    }
}

fn is_identifier(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && text != "_"
}

/// Takes the settings of a `device` attribute; others are not ours.
fn read_attribute(attribute: TokenStream, settings: &mut [Option<Setting>; 4]) -> Result<(), Fault> {
    let mut tokens = attribute.into_iter();
    let Some(TokenTree::Ident(name)) = tokens.next() else { return Ok(()) };
    if name != "device" {
        return Ok(());
    }
    let Some(TokenTree::Group(list)) = tokens.next() else {
        return Err(Fault::new(name.span(), "expected `device(path = \"..\")`"));
    };
    let mut tokens = list.stream().into_iter().peekable();
    while tokens.peek().is_some() {
        read_setting(&mut tokens, list.span(), settings)?;
    }
    Ok(())
}

fn read_setting(
    tokens: &mut impl Iterator<Item = TokenTree>,
    list: Span,
    settings: &mut [Option<Setting>; 4],
) -> Result<(), Fault> {
    let (key, equals, value) = (tokens.next(), tokens.next(), tokens.next());
    let span = key.as_ref().map_or(list, TokenTree::span);
    let (Some(TokenTree::Ident(key)), Some(TokenTree::Punct(equals)), Some(TokenTree::Literal(value))) =
        (key, equals, value)
    else {
        return Err(Fault::new(span, "expected a setting such as `path = \"devices/c887\"`"));
    };
    let text = unquoted(&value.to_string()).filter(|_| equals.as_char() == '=');
    let text =
        text.ok_or_else(|| Fault::new(value.span(), format!("expected `{key} = \"..\"`, a plain text")))?;
    let place = KEYS.iter().position(|known| key == *known);
    let setting = place.and_then(|place| settings.get_mut(place)).ok_or_else(|| {
        Fault::new(
            key.span(),
            format!("there is no setting `{key}`, but {}", KEYS.map(|key| format!("`{key}`")).join(", ")),
        )
    })?;
    if setting.replace((text, value.span())).is_some() {
        return Err(Fault::new(key.span(), format!("`{key}` is set twice")));
    }
    match tokens.next() {
        Some(TokenTree::Punct(comma)) if comma.as_char() == ',' => Ok(()),
        None => Ok(()),
        Some(other) => Err(Fault::new(other.span(), "expected a comma")),
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

/// The name, if it is `pub struct Name;`.
fn unit_struct(tokens: impl Iterator<Item = TokenTree>) -> Result<Ident, Fault> {
    let mut tokens = tokens.peekable();
    let is_pub = matches!(tokens.peek(), Some(TokenTree::Ident(word)) if word == "pub");
    let mut is_restricted = false;
    if is_pub {
        tokens.next();
        is_restricted = tokens.next_if(|token| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis)).is_some();
    }
    let (keyword, name, end) = (tokens.next(), tokens.next(), tokens.next());
    match (keyword, name, end) {
        (Some(TokenTree::Ident(keyword)), Some(TokenTree::Ident(name)), Some(TokenTree::Punct(end)))
            if keyword == "struct" && end.as_char() == ';' =>
        {
            if is_pub && !is_restricted {
                return Ok(name);
            }
            let why = "the types of its process data are public and name it";
            Err(Fault::new(name.span(), format!("`{name}` has to be `pub struct {name};`: {why}")))
        }
        (keyword, name, _) => {
            let span = name.or(keyword).map_or_else(Span::call_site, |token| token.span());
            Err(Fault::new(
                span,
                "a device is a unit struct, such as `pub struct C887;`: the description is all there is to it",
            ))
        }
    }
}
