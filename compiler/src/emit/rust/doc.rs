//! Doc comments.

use proc_macro2::TokenStream;
use quote::{ToTokens, TokenStreamExt, quote};

use crate::model::{Device, Source};

/// Columns of a line of documentation.
const WIDTH: usize = 100;

/// The documentation of an item: a title, then paragraphs.
#[derive(Debug, Clone, Default)]
pub(super) struct Doc {
    lines: Vec<String>,
}

impl Doc {
    /// Documentation that begins with a line, in Markdown.
    pub(super) fn new(title: impl AsRef<str>) -> Self {
        Self::default().text(title.as_ref())
    }

    /// Another paragraph, in Markdown.
    pub(super) fn text(mut self, text: &str) -> Self {
        if text.is_empty() {
            return self;
        }
        if !self.lines.is_empty() {
            self.lines.push(String::new());
        }
        wrap(text, &mut self.lines);
        self
    }

    /// Another paragraph, if there is one, of plain text.
    pub(super) fn maybe(self, text: Option<&str>) -> Self {
        match text {
            Some(text) => self.text(&escape(text)),
            None => self,
        }
    }

    /// Lines as they are, such as those of a table.
    pub(super) fn lines(mut self, lines: impl IntoIterator<Item = String>) -> Self {
        self.lines.push(String::new());
        self.lines.extend(lines);
        self
    }

    /// Where the facts are from, if that is known.
    pub(super) fn source(self, source: Option<&Source>, device: &Device) -> Self {
        match source {
            Some(source) => self.text(&format!("Source: {}.", escape(&place(source, device)))),
            None => self,
        }
    }

    /// The documentation of the module that it stands in.
    pub(super) fn inner(&self) -> TokenStream {
        let lines = self.lines.iter().map(|line| spaced(line));
        quote!(#(#![doc = #lines])*)
    }
}

impl ToTokens for Doc {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let lines = self.lines.iter().map(|line| spaced(line));
        tokens.append_all(quote!(#(#[doc = #lines])*));
    }
}

/// A line as `///` has it.
fn spaced(line: &str) -> String {
    if line.is_empty() { String::new() } else { format!(" {line}") }
}

/// The place, with the document's number if it is not the main one.
pub(super) fn place(source: &Source, device: &Device) -> String {
    let named =
        source.document.as_ref().and_then(|id| device.documents.iter().find(|document| document.id == *id));
    match (named, device.documents.first()) {
        (Some(document), Some(main)) if document.id != main.id => {
            format!("{}, {}", document.number.as_ref().unwrap_or(&document.title), source.place)
        }
        _ => source.place.clone(),
    }
}

/// Plain text in which nothing is taken for Markdown.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '[' | ']' | '<' | '>' | '*' | '`' | '_') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// A name as the beginning of a sentence, with a full stop.
pub(super) fn sentence(text: &str) -> String {
    let text = text.trim();
    let mut chars = text.chars();
    let first = chars.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    let stop = if text.ends_with(['.', '!', '?']) { "" } else { "." };
    escape(&format!("{first}{}{stop}", chars.as_str()))
}

fn wrap(text: &str, lines: &mut Vec<String>) {
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines.push(line);
}
