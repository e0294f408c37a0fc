//! Access as types: what may be done with an entry is known when the code is compiled.

use crate::sdo::Access;

mod sealed {
    pub trait Sealed {}
}

/// One of the four kinds of access (CiA 301, attributes of an object).
pub trait Marker: sealed::Sealed {
    /// The same at run time, for every communication state.
    const ACCESS: Access;
}

/// An entry that may be read: by SDO upload.
pub trait Readable: Marker {}

/// An entry that may be written: by SDO download.
pub trait Writable: Marker {}

macro_rules! marker {
    ($(#[$doc:meta])* $name:ident, $access:expr $(, $ability:ident)*) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name {}
        impl sealed::Sealed for $name {}
        impl Marker for $name {
            const ACCESS: Access = $access;
        }
        $(impl $ability for $name {})*
    };
}

marker!(
    /// `ro`: may be read; the device may change it.
    ReadOnly, Access::READ, Readable
);
marker!(
    /// `const`: may be read and never changes.
    Constant, Access::READ, Readable
);
marker!(
    /// `wo`: may be written, there is nothing to read.
    WriteOnly, Access::WRITE, Writable
);
marker!(
    /// `rw`: may be read and written.
    ReadWrite, Access::READ.and(Access::WRITE), Readable, Writable
);
