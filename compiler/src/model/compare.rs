//! What differs between two parts of the model, field by field.
//!
//! The macros that declare the model make the comparison, so that no field is forgotten. Lists are matched by what tells
//! their items apart; where a thing was written is not compared.

use std::collections::{BTreeMap, BTreeSet};

use super::Source;
use super::difference::{Difference, FieldPath};
pub use super::walk::Walker;
use crate::source::{Location, Origin};

/// A part of the model.
pub trait Compare: PartialEq + Sized {
    /// Whether it is one value, not made of parts that are told apart.
    const IS_VALUE: bool = false;

    /// What tells it from its siblings in a list; its place does if there is nothing.
    fn key(&self) -> Option<String> {
        None
    }

    /// The value for people; what is made of parts is called by its name.
    fn shown(&self) -> String;

    /// Where it was written, if it knows that itself.
    fn origin(&self) -> Option<&Origin> {
        None
    }

    /// Itself, if it is what says where something was written.
    fn as_origin(&self) -> Option<&Origin> {
        None
    }

    /// Whether another that does not differ is told in the same order, from the same sources, with the same marks.
    fn is_told_alike(&self, _: &Self, _: &dyn Beside) -> bool {
        true
    }

    /// Hands on what differs from another, at a path; what is one value differs as a whole.
    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
        values(self, other, path, found);
    }

    /// Shows the texts and the lists of values in it, at a path.
    fn walk(&self, _: &mut FieldPath, _: &mut dyn Walker) {}
}

/// What is told beside parts of two devices.
pub trait Beside {
    /// Whether two places are in the same document.
    fn is_same_source(&self, first: &Source, second: &Source) -> bool;

    /// Whether each fact of two tables is said by the same.
    fn is_same_author(&self, first: &Origin, second: &Origin) -> bool;
}

/// What differs between two parts of the model, in the order of their fields.
pub fn differences<T: Compare>(first: &T, second: &T) -> Vec<Difference> {
    let mut found = Vec::new();
    first.compare(second, &mut FieldPath::default(), &mut |difference| found.push(difference));
    found
}

/// Compares single values.
fn values<T: Compare>(first: &T, second: &T, path: &FieldPath, found: &mut dyn FnMut(Difference)) {
    if first != second {
        found(path.differ(Some(first.shown()), Some(second.shown())));
    }
}

/// Makes types single values.
macro_rules! value {
    ($($type:ty)+) => {
        $(
            impl $crate::model::Compare for $type {
                const IS_VALUE: bool = true;

                fn shown(&self) -> String {
                    self.to_string()
                }
            }
        )+
    };
}
pub(crate) use value;

value! { bool u8 i8 u16 i16 u32 i32 u64 i64 f64 }

impl Compare for String {
    const IS_VALUE: bool = true;

    fn shown(&self) -> String {
        self.clone()
    }

    fn walk(&self, path: &mut FieldPath, walker: &mut dyn Walker) {
        walker.text(path, self);
    }
}

impl<T: Compare> Compare for Option<T> {
    const IS_VALUE: bool = T::IS_VALUE;

    fn shown(&self) -> String {
        self.as_ref().map(T::shown).unwrap_or_default()
    }

    fn is_told_alike(&self, other: &Self, beside: &dyn Beside) -> bool {
        self.as_ref().zip(other.as_ref()).is_none_or(|(first, second)| first.is_told_alike(second, beside))
    }

    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
        match (self, other) {
            (Some(first), Some(second)) => first.compare(second, path, found),
            (None, None) => {}
            (first, second) => {
                found(path.differ(first.as_ref().map(T::shown), second.as_ref().map(T::shown)));
            }
        }
    }

    fn walk(&self, path: &mut FieldPath, walker: &mut dyn Walker) {
        self.iter().for_each(|one| one.walk(path, walker));
    }
}

impl<T: Compare> Compare for Vec<T> {
    const IS_VALUE: bool = T::IS_VALUE;

    fn shown(&self) -> String {
        self.iter().map(T::shown).collect::<Vec<_>>().join(", ")
    }

    fn is_told_alike(&self, other: &Self, beside: &dyn Beside) -> bool {
        let is_one =
            |(first, second): (&T, &T)| first.key() == second.key() && first.is_told_alike(second, beside);
        self.iter().zip(other).all(is_one)
    }

    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
        if T::IS_VALUE {
            return values(self, other, path, found);
        }
        let [firsts, seconds] = [self, other].map(|items| keyed(items));
        order(&firsts, &seconds, path, found);
        let mut seconds: BTreeMap<String, &T> = seconds.into_iter().collect();
        for (key, first) in firsts.into_iter().collect::<BTreeMap<_, _>>() {
            let second = seconds.remove(&key);
            path.within(key, |path| match second {
                Some(second) => first.compare(second, path, found),
                None => {
                    let gone = path.differ(Some(first.shown()), None);
                    found(gone.written(path.0.len(), first.origin(), None));
                }
            });
        }
        for (key, second) in seconds {
            path.within(key, |path| {
                let new = path.differ(None, Some(second.shown()));
                found(new.written(path.0.len(), None, second.origin()));
            });
        }
    }

    fn walk(&self, path: &mut FieldPath, walker: &mut dyn Walker) {
        if T::IS_VALUE {
            walker.list(path, &mut self.iter().map(T::shown));
        }
        for (place, item) in self.iter().enumerate() {
            let key = item.key().unwrap_or_else(|| place.to_string());
            path.within(key, |path| item.walk(path, walker));
        }
    }
}

/// The items of a list, each with what tells it apart.
fn keyed<T: Compare>(items: &[T]) -> Vec<(String, &T)> {
    let key = |(place, item): (usize, &T)| item.key().unwrap_or_else(|| format!("{place:03}"));
    items.iter().enumerate().map(|(place, item)| (key((place, item)), item)).collect()
}

/// Those of the items of a list that another list has, too.
fn within<'t, T>(items: &[(String, &'t T)], others: &[(String, &T)]) -> Vec<(String, &'t T)> {
    let others: BTreeSet<&String> = others.iter().map(|(key, _)| key).collect();
    items.iter().filter(|(key, _)| others.contains(key)).map(|(key, item)| (key.clone(), *item)).collect()
}

/// Compares the order of what is in both of two lists.
fn order<T: Compare>(
    firsts: &[(String, &T)],
    seconds: &[(String, &T)],
    path: &FieldPath,
    found: &mut dyn FnMut(Difference),
) {
    if firsts.iter().map(|(key, _)| key).eq(seconds.iter().map(|(key, _)| key)) {
        return;
    }
    let (firsts, seconds) = (within(firsts, seconds), within(seconds, firsts));
    let Some(((_, first), (_, second))) = firsts.iter().zip(&seconds).find(|(one, other)| one.0 != other.0)
    else {
        return;
    };
    let [before, after] = [&firsts, &seconds]
        .map(|items| items.iter().map(|(key, _)| key.as_str()).collect::<Vec<_>>().join(", "));
    let difference = Difference { is_order: true, ..path.differ(Some(before), Some(after)) };
    found(difference.written(path.0.len(), first.origin(), second.origin()));
}

impl<T: Compare> Compare for (T, T) {
    const IS_VALUE: bool = true;

    fn shown(&self) -> String {
        format!("{} to {}", self.0.shown(), self.1.shown())
    }
}

/// Where a thing was written is not part of what it is.
impl Compare for Origin {
    fn shown(&self) -> String {
        String::new()
    }

    fn as_origin(&self) -> Option<&Origin> {
        Some(self)
    }

    fn is_told_alike(&self, other: &Self, beside: &dyn Beside) -> bool {
        beside.is_same_author(self, other)
    }

    fn compare(&self, _: &Self, _: &mut FieldPath, _: &mut dyn FnMut(Difference)) {}
}

impl Compare for Source {
    const IS_VALUE: bool = true;

    fn shown(&self) -> String {
        self.to_string()
    }

    fn is_told_alike(&self, other: &Self, beside: &dyn Beside) -> bool {
        beside.is_same_source(self, other)
    }

    fn walk(&self, path: &mut FieldPath, walker: &mut dyn Walker) {
        walker.text(path, &self.place);
    }
}

impl Compare for Location {
    fn shown(&self) -> String {
        String::new()
    }

    fn compare(&self, _: &Self, _: &mut FieldPath, _: &mut dyn FnMut(Difference)) {}
}
