//! What is made of the declaration of a part of the model.

use std::fmt;

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
                $(
                    if stringify!($field) == "name" {
                        return $crate::model::Compare::shown(&self.$field);
                    }
                )*
                stringify!($name).to_owned()
            }

            fn origin(&self) -> Option<&$crate::source::Origin> {
                None$(.or_else(|| $crate::model::Compare::as_origin(&self.$field)))*
            }

            fn is_told_alike(&self, other: &Self, beside: &dyn $crate::model::Beside) -> bool {
                true $(&& $crate::model::Compare::is_told_alike(&self.$field, &other.$field, beside))*
            }

            fn compare(
                &self,
                other: &Self,
                path: &mut $crate::model::FieldPath,
                found: &mut dyn FnMut($crate::model::Difference),
            ) {
                let (depth, first, second) = (
                    path.0.len(),
                    $crate::model::Compare::origin(self),
                    $crate::model::Compare::origin(other),
                );
                let found: &mut dyn FnMut($crate::model::Difference) =
                    &mut |difference| found(difference.written(depth, first, second));
                $(
                    path.within(const { $crate::model::compared::field(stringify!($field)) }, |path| {
                        $crate::model::Compare::compare(&self.$field, &other.$field, path, found);
                    });
                )*
            }

            fn walk(&self, path: &mut $crate::model::FieldPath, walker: &mut dyn $crate::model::Walker) {
                let origin = $crate::model::Compare::origin(self);
                origin.into_iter().for_each(|origin| walker.enter(path, origin));
                $(
                    path.within(const { $crate::model::compared::field(stringify!($field)) }, |path| {
                        $crate::model::Compare::walk(&self.$field, path, walker);
                    });
                )*
                origin.into_iter().for_each(|_| walker.leave());
            }
        }
    };
    ($kind:ident $name:ident [] $body:tt) => {
        impl $crate::model::Compare for $name {
            const IS_VALUE: bool = true;

            fn shown(&self) -> String {
                $crate::model::compared::word(self)
            }
        }
    };
}
pub(crate) use compared;

/// The name of a field, which may be a word of Rust (`r#type`).
pub(crate) const fn field(name: &'static str) -> &'static str {
    match name.as_bytes() {
        [b'r', b'#', ..] => name.split_at(2).1,
        _ => name,
    }
}

/// A choice as a word.
pub(crate) fn word(choice: &dyn fmt::Debug) -> String {
    let mut word = String::new();
    for letter in format!("{choice:?}").chars() {
        if letter.is_uppercase() && !word.is_empty() {
            word.push('-');
        }
        word.extend(letter.to_lowercase());
    }
    word
}
