//! What is made while the program runs and lasts as long as it does.
//!
//! The runtime takes tables that are `'static`, because in a device they are constants: so it needs neither lifetimes nor
//! an allocator. Here they are made from a description, once for each device, and never given back. A program that serves
//! a device does so to its end, and one that serves many makes the tables of each once.

/// A value.
pub(super) fn value<T>(value: T) -> &'static T {
    Box::leak(Box::new(value))
}

/// Values in a row.
pub(super) fn all<T>(values: impl IntoIterator<Item = T>) -> &'static [T] {
    values.into_iter().collect::<Vec<T>>().leak()
}

/// A text.
pub(super) fn text(text: &str) -> &'static str {
    text.to_owned().leak()
}
