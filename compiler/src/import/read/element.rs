//! Elements of XML that remember what of them was read.
//!
//! Whatever nobody asked for is a loss, so that none can be forgotten: elements and attributes carry a mark that reading
//! sets, and `unread` gathers what has none.

use std::borrow::Cow;
use std::cell::Cell;

/// A place in the text: the number of its first byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(crate) struct At(pub(crate) usize);

/// An element with what is in it.
#[derive(Debug)]
pub(crate) struct Element<'t> {
    pub(super) name: &'t str,
    pub(super) at: At,
    pub(super) attributes: Vec<Attribute<'t>>,
    pub(super) text: Cow<'t, str>,
    pub(super) children: Vec<Element<'t>>,
    pub(super) read: Cell<bool>,
    pub(super) idle: Cell<bool>,
}

#[derive(Debug)]
pub(super) struct Attribute<'t> {
    pub(super) name: &'t str,
    pub(super) value: Cow<'t, str>,
    pub(super) read: Cell<bool>,
}

/// Something that nobody read.
#[derive(Debug)]
pub(crate) struct Unread {
    /// Where it stands in the tree, as `RxPdo/@Su`.
    pub(crate) path: String,
    /// Where it stands in the text.
    pub(crate) at: At,
    /// What it says; of an element with others in it nothing.
    pub(crate) value: String,
    /// How many facts it holds.
    pub(crate) facts: usize,
}

impl<'t> Element<'t> {
    pub(crate) fn name(&self) -> &'t str {
        self.name
    }

    pub(crate) fn at(&self) -> At {
        self.at
    }

    /// The text, without the blanks around it.
    pub(crate) fn text(&self) -> &str {
        self.read.set(true);
        self.text.trim()
    }

    /// The text, without the blanks around it; asking is not reading.
    pub(super) fn plain(&self) -> &str {
        self.text.trim()
    }

    /// An attribute, without the blanks around it.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        let attribute = self.attributes.iter().find(|attribute| attribute.name == name)?;
        attribute.read.set(true);
        Some(attribute.value.trim())
    }

    /// What an attribute is read as; one that cannot be read so stays unread.
    pub(crate) fn attribute_as<T>(&self, name: &str, read: impl FnOnce(&str) -> Option<T>) -> Option<T> {
        let attribute = self.attributes.iter().find(|attribute| attribute.name == name)?;
        let value = read(attribute.value.trim())?;
        attribute.read.set(true);
        Some(value)
    }

    /// What the text of the first child of a name is read as; one that cannot be read so stays unread.
    pub(crate) fn child_as<T>(&self, name: &str, read: impl FnOnce(&str) -> Option<T>) -> Option<T> {
        let child = self.children.iter().find(|child| child.name == name)?;
        let value = read(child.text.trim())?;
        child.read.set(true);
        Some(value)
    }

    /// The first child of a name.
    pub(crate) fn child(&self, name: &str) -> Option<&Self> {
        let child = self.children.iter().find(|child| child.name == name)?;
        child.read.set(true);
        Some(child)
    }

    /// All children of a name.
    pub(crate) fn all<'e>(&'e self, name: &'e str) -> impl Iterator<Item = &'e Self> + use<'e, 't> {
        let found = self.children.iter().filter(move |child| child.name == name);
        found.inspect(|child| child.read.set(true))
    }

    /// Passes over an attribute that says what holds without it: `false`.
    pub(super) fn says_usual(&self, name: &str) {
        self.attribute_as(name, |text| super::number::truth(text).filter(|it| !it));
    }

    /// All children, which are not read by that.
    pub(crate) fn children(&self) -> &[Self] {
        &self.children
    }

    /// Says that what is in it says nothing of the device: it counts neither as a fact nor as a loss.
    pub(super) fn is_idle(&self) {
        self.idle.set(true);
    }

    /// Whether it has no text; asking is not reading.
    pub(crate) fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }

    /// Whether it has an attribute of this value; asking is not reading.
    pub(super) fn has(&self, name: &str, value: &str) -> bool {
        self.attributes.iter().any(|attribute| attribute.name == name && attribute.value.trim() == value)
    }

    /// Whether it has an attribute; asking is not reading.
    pub(super) fn has_any(&self, name: &str) -> bool {
        self.attributes.iter().any(|attribute| attribute.name == name)
    }

    /// How many facts it holds: attributes and texts.
    pub(crate) fn facts(&self) -> usize {
        let mut facts = 0;
        let mut open = vec![self];
        while let Some(element) = open.pop() {
            if element.idle.get() {
                continue;
            }
            facts += element.attributes.len() + usize::from(element.is_leaf());
            open.extend(&element.children);
        }
        facts
    }

    fn is_leaf(&self) -> bool {
        self.children.is_empty() && !self.text.trim().is_empty()
    }

    /// What nobody read of it.
    pub(crate) fn unread(&self) -> Vec<Unread> {
        let mut unread = Vec::new();
        self.gather(&mut unread);
        unread.sort_by_key(|it| it.at);
        unread
    }

    fn gather(&self, unread: &mut Vec<Unread>) {
        for attribute in self.attributes.iter().filter(|attribute| !attribute.read.get()) {
            let path = format!("{}/@{}", self.name, attribute.name);
            unread.push(Unread { path, at: self.at, value: attribute.value.to_string(), facts: 1 });
        }
        for child in self.children.iter().filter(|child| !child.idle.get()) {
            if child.read.get() {
                child.gather(unread);
            } else if child.facts() > 0 {
                let path = format!("{}/{}", self.name, child.name);
                let value = if child.is_leaf() { child.text.trim().to_owned() } else { String::new() };
                unread.push(Unread { path, at: child.at, value, facts: child.facts() });
            }
        }
    }
}
