//! How the parts of the model are declared.

/// Declares parts of the model. `by id` names what tells a part from its siblings.
macro_rules! model {
    ($($(#[$meta:meta])* pub $kind:ident $name:ident $(by $key:ident)? { $($body:tt)* })*) => {
        $crate::model::plain! { $($(#[$meta])* pub $kind $name { $($body)* })* }
        $($crate::model::compared::compared! { $kind $name [$($key)?] { $($body)* } })*
    };
}
pub(crate) use model;

/// Declares values of the model, which are compared as a whole.
macro_rules! plain {
    ($($item:item)*) => {
        $(
            #[derive(Debug, Clone, PartialEq)]
            #[cfg_attr(feature = "json", derive(serde::Serialize))]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            $item
        )*
    };
}
pub(crate) use plain;
