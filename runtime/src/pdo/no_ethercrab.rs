//! What stands for the traits of `ethercrab-wire` without them.

/// Implements nothing: the feature `ethercrab` is off.
#[doc(hidden)]
#[macro_export]
macro_rules! ethercrab {
    ($data:ident, $length:expr) => {};
}
