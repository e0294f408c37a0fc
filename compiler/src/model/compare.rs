//! What differs between two parts of the model, field by field.
//!
//! The macros that declare the model make the comparison, so that no field is forgotten. Lists are matched by what tells
//! their items apart; where a thing was written is not compared.

use std::collections::BTreeMap;
use std::fmt;

/// A way from a part of the model down to a value: `objects`, `0x6040`, `entries`, `0`, `default`.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct FieldPath(pub Vec<String>);

/// What differs at a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Where.
    pub path: FieldPath,
    /// The value in the first of the two; none if it lacks what stands there.
    pub first: Option<String>,
    /// The value in the second.
    pub second: Option<String>,
}

/// A part of the model.
pub trait Compare: PartialEq {
    /// Whether it is one value, not made of parts that are told apart.
    const IS_VALUE: bool = false;

    /// What tells it from its siblings in a list; its place does if there is nothing.
    fn key(&self) -> Option<String> {
        None
    }

    /// The value for people; the name of what is made of parts.
    fn shown(&self) -> String;

    /// Hands on what differs from another, at a path.
    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference));
}

/// What differs between two parts of the model, in the order of their fields.
pub fn differences<T: Compare>(first: &T, second: &T) -> Vec<Difference> {
    let mut found = Vec::new();
    first.compare(second, &mut FieldPath::default(), &mut |difference| found.push(difference));
    found
}

impl FieldPath {
    /// Does something one step further down.
    pub(crate) fn within(&mut self, step: impl Into<String>, act: impl FnOnce(&mut Self)) {
        self.0.push(step.into());
        act(self);
        self.0.pop();
    }

    fn differ(&self, first: Option<String>, second: Option<String>) -> Difference {
        Difference { path: self.clone(), first, second }
    }
}

impl fmt::Display for FieldPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join("."))
    }
}

/// Compares single values.
pub(crate) fn values<T: Compare>(first: &T, second: &T, path: &FieldPath, found: &mut dyn FnMut(Difference)) {
    if first != second {
        found(path.differ(Some(first.shown()), Some(second.shown())));
    }
}

/// Makes types single values.
macro_rules! value {
    ($($type:ty)+) => {
        $(
            impl Compare for $type {
                const IS_VALUE: bool = true;

                fn shown(&self) -> String {
                    self.to_string()
                }

                fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
                    values(self, other, path, found);
                }
            }
        )+
    };
}
value! {
    bool u8 i8 u16 i16 u32 i32 u64 i64 f64 String
    super::Said super::Place super::Index super::Address super::DataType super::Pattern super::Value super::Duration super::Delay
    super::Hex super::Scale super::Source
}

impl<T: Compare> Compare for Option<T> {
    const IS_VALUE: bool = T::IS_VALUE;

    fn shown(&self) -> String {
        self.as_ref().map(T::shown).unwrap_or_default()
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
}

impl<T: Compare> Compare for Vec<T> {
    const IS_VALUE: bool = T::IS_VALUE;

    fn shown(&self) -> String {
        self.iter().map(T::shown).collect::<Vec<_>>().join(", ")
    }

    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
        if T::IS_VALUE {
            return values(self, other, path, found);
        }
        let mut seconds = keyed(other);
        for (key, first) in keyed(self) {
            let second = seconds.remove(&key);
            path.within(key, |path| match second {
                Some(second) => first.compare(second, path, found),
                None => found(path.differ(Some(first.shown()), None)),
            });
        }
        for (key, second) in seconds {
            path.within(key, |path| found(path.differ(None, Some(second.shown()))));
        }
    }
}

fn keyed<T: Compare>(items: &[T]) -> BTreeMap<String, &T> {
    let key = |(place, item): (usize, &T)| item.key().unwrap_or_else(|| format!("{place:03}"));
    items.iter().enumerate().map(|(place, item)| (key((place, item)), item)).collect()
}

impl<T: Compare> Compare for (T, T) {
    const IS_VALUE: bool = true;

    fn shown(&self) -> String {
        format!("{} to {}", self.0.shown(), self.1.shown())
    }

    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
        values(self, other, path, found);
    }
}

impl Compare for super::OneOrMore {
    const IS_VALUE: bool = true;

    fn shown(&self) -> String {
        self.0.shown()
    }

    fn compare(&self, other: &Self, path: &mut FieldPath, found: &mut dyn FnMut(Difference)) {
        values(self, other, path, found);
    }
}

/// Where a thing was written is not part of what it is.
impl Compare for crate::source::Origin {
    fn shown(&self) -> String {
        String::new()
    }

    fn compare(&self, _: &Self, _: &mut FieldPath, _: &mut dyn FnMut(Difference)) {}
}

impl Compare for crate::source::Location {
    fn shown(&self) -> String {
        String::new()
    }

    fn compare(&self, _: &Self, _: &mut FieldPath, _: &mut dyn FnMut(Difference)) {}
}

/// Makes the comparison of a part of the model from its declaration.
macro_rules! compared {
    (struct $name:ident [$($key:ident)?] { $($(#[$meta:meta])* pub $field:ident: $type:ty,)* }) => {
        impl $crate::model::Compare for $name {
            $(
                fn key(&self) -> Option<String> {
                    Some($crate::model::Compare::shown(&self.$key))
                }
            )?

            fn shown(&self) -> String {
                stringify!($name).to_owned()
            }

            fn compare(
                &self,
                other: &Self,
                path: &mut $crate::model::FieldPath,
                found: &mut dyn FnMut($crate::model::Difference),
            ) {
                $(
                    path.within(stringify!($field), |path| {
                        $crate::model::Compare::compare(&self.$field, &other.$field, path, found);
                    });
                )*
            }
        }
    };
    ($kind:ident $name:ident [] $body:tt) => {
        impl $crate::model::Compare for $name {
            const IS_VALUE: bool = true;

            fn shown(&self) -> String {
                $crate::model::compare::word(self)
            }

            fn compare(
                &self,
                other: &Self,
                path: &mut $crate::model::FieldPath,
                found: &mut dyn FnMut($crate::model::Difference),
            ) {
                $crate::model::compare::values(self, other, path, found);
            }
        }
    };
}
pub(crate) use compared;

/// A choice as a word.
pub(crate) fn word(choice: &dyn fmt::Debug) -> String {
    format!("{choice:?}").to_lowercase()
}
