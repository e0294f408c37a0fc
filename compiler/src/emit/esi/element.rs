//! XML as a tree, and how it is written.

use std::borrow::Cow;
use std::fmt::Display;
use std::io;

use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};
use quick_xml::writer::Writer;

use crate::emit::escape::comment;
use crate::model::{Language, Translations};
use crate::text::characters::harmless;

/// The language of the texts of descriptions: English.
const ENGLISH: u16 = 1033;

/// An element with either text or children in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Element {
    name: &'static str,
    attributes: Vec<(&'static str, String)>,
    text: Option<String>,
    children: Vec<Element>,
}

impl Element {
    /// An element with nothing in it.
    pub(super) fn new(name: &'static str) -> Self {
        Self { name, attributes: Vec::new(), text: None, children: Vec::new() }
    }

    /// An element with a value in it.
    pub(super) fn leaf(name: &'static str, value: impl Display) -> Self {
        Self { text: Some(printable(value)), ..Self::new(name) }
    }

    /// An element with a text for people in it.
    pub(super) fn worded(name: &'static str, text: impl Display) -> Self {
        Self::leaf(name, text).with("LcId", ENGLISH)
    }

    /// A text for people in another language.
    pub(super) fn translated(name: &'static str, text: impl Display, language: Language) -> Self {
        Self::leaf(name, text).with("LcId", language.lcid())
    }

    /// Elements with a text for people, one for each language.
    pub(super) fn in_languages(
        name: &'static str,
        english: impl Display,
        others: &Translations,
    ) -> Vec<Self> {
        let others = others.iter().map(|it| Self::translated(name, &it.text, it.language));
        std::iter::once(Self::worded(name, english)).chain(others).collect()
    }

    /// Adds an attribute.
    pub(super) fn with(mut self, name: &'static str, value: impl Display) -> Self {
        self.attributes.push((name, printable(value)));
        self
    }

    /// Adds an attribute that is true or false.
    pub(super) fn with_flag(self, name: &'static str, value: bool) -> Self {
        self.with(name, u8::from(value))
    }

    /// Adds an attribute if it has a value.
    pub(super) fn with_some(self, name: &'static str, value: Option<impl Display>) -> Self {
        match value {
            Some(value) => self.with(name, value),
            None => self,
        }
    }

    /// Adds a child, if there is one.
    pub(super) fn child(mut self, child: impl Into<Option<Element>>) -> Self {
        self.children.extend(child.into());
        self
    }

    /// Adds children.
    pub(super) fn children(mut self, children: impl IntoIterator<Item = Element>) -> Self {
        self.children.extend(children);
        self
    }

    /// The element, unless nothing is in it.
    pub(super) fn unless_empty(self) -> Option<Self> {
        (!self.children.is_empty() || self.text.is_some()).then_some(self)
    }

    fn write(&self, writer: &mut Writer<Vec<u8>>) -> io::Result<()> {
        let attributes = self.attributes.iter().map(|(name, value)| (*name, value.as_str()));
        let start = BytesStart::new(self.name).with_attributes(attributes);
        if self.children.is_empty() && self.text.is_none() {
            return writer.write_event(Event::Empty(start));
        }
        writer.write_event(Event::Start(start))?;
        if let Some(text) = &self.text {
            writer.write_event(Event::Text(BytesText::new(text)))?;
        }
        for child in &self.children {
            child.write(writer)?;
        }
        writer.write_event(Event::End(BytesEnd::new(self.name)))
    }
}

/// A document: a comment at the head, then the root.
pub(super) fn document(heading: &str, root: &Element) -> String {
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    let comment = BytesText::from_escaped(comment(&printable(heading)));
    let written = writer
        .write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))
        .and_then(|()| writer.write_event(Event::Comment(comment)))
        .and_then(|()| root.write(&mut writer));
    debug_assert!(written.is_ok(), "a Vec takes all that is written to it");
    let text = String::from_utf8(writer.into_inner());
    let mut text = text.unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
    text.push('\n');
    text
}

/// The text without what XML 1.0 bans, such as NUL, and what else no output can hold.
fn printable(text: impl Display) -> String {
    let text = text.to_string();
    match harmless(&text) {
        Cow::Borrowed(_) => text,
        Cow::Owned(harmless) => harmless,
    }
}

#[cfg(test)]
mod tests {
    use super::{Element, document};

    #[test]
    fn markup_in_values_is_escaped() {
        let root = Element::new("A").with("b", "\"<&>\"").child(Element::leaf("C", "<&>"));
        let expected = "<A b=\"&quot;&lt;&amp;&gt;&quot;\">\n  <C>&lt;&amp;&gt;</C>\n</A>\n";
        assert_eq!(document("", &root).split_once("-->\n").unwrap().1, expected);
    }

    #[test]
    fn what_xml_bans_is_replaced() {
        let text = document("nul \0", &Element::leaf("A", "bell \x07, tab \t"));
        assert!(text.contains("nul \u{FFFD}"), "{text}");
        assert!(text.contains("bell \u{FFFD}, tab \t"), "{text}");
    }

    #[test]
    fn a_comment_ends_where_the_text_ends() {
        let text = document("a --> b --- c\n", &Element::new("A"));
        assert!(text.contains("<!--a - -> b - - - c\n-->\n<A/>"), "{text}");
    }
}
