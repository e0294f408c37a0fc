//! Entries with everything that the compiler can check about them.

use core::fmt;
use core::marker::PhantomData;

use super::{Address, Marker, Readable, Value, Writable};
use crate::bytes::WrongLength;
use crate::sdo::Access;

/// An entry of the dictionary of device `D`, of Rust type `T` (`str` for a visible string), with access `A`.
///
/// It is no more than its address at run time. Generated code has one constant for each entry:
///
/// ```
/// use devc_runtime::object::{Entry, ReadOnly, ReadWrite};
///
/// enum C887 {}
/// const TARGET_POSITION: Entry<C887, i32, ReadWrite> = Entry::new(0x607A, 0);
/// const POSITION_ACTUAL_VALUE: Entry<C887, i32, ReadOnly> = Entry::new(0x6064, 0);
///
/// assert_eq!(TARGET_POSITION.encode(-1), [0xFF; 4]);
/// assert_eq!(POSITION_ACTUAL_VALUE.decode(&[2, 0, 0, 0]), Ok(2));
/// ```
///
/// Writing what may only be read does not compile:
///
/// ```compile_fail,E0277
/// # use devc_runtime::object::{Entry, ReadOnly};
/// # enum C887 {}
/// # const POSITION_ACTUAL_VALUE: Entry<C887, i32, ReadOnly> = Entry::new(0x6064, 0);
/// POSITION_ACTUAL_VALUE.encode(0);
/// ```
///
/// Nor does a value of another type:
///
/// ```compile_fail,E0308
/// # use devc_runtime::object::{Entry, ReadWrite};
/// # enum C887 {}
/// # const TARGET_POSITION: Entry<C887, i32, ReadWrite> = Entry::new(0x607A, 0);
/// TARGET_POSITION.encode(0_i16);
/// ```
///
/// Nor an entry of another device where this one's is asked for:
///
/// ```compile_fail,E0308
/// # use devc_runtime::object::{Entry, ReadWrite};
/// # enum C887 {}
/// # enum S700 {}
/// # const TARGET_POSITION: Entry<C887, i32, ReadWrite> = Entry::new(0x607A, 0);
/// let of_the_s700: Entry<S700, i32, ReadWrite> = TARGET_POSITION;
/// ```
pub struct Entry<D, T: ?Sized, A> {
    address: Address,
    checked: PhantomData<(D, A, T)>,
}

impl<D, T: ?Sized, A> Entry<D, T, A> {
    /// The entry at `index`:`subindex`. Types are promised here and relied on everywhere else, so this is for
    /// generated code.
    pub const fn new(index: u16, subindex: u8) -> Self {
        Self { address: Address::new(index, subindex), checked: PhantomData }
    }

    /// Where the entry is.
    pub const fn address(self) -> Address {
        self.address
    }
}

impl<D, T: ?Sized, A: Marker> Entry<D, T, A> {
    /// The access to the entry at run time, not counting that it may depend on the communication state.
    pub const fn access(self) -> Access {
        A::ACCESS
    }
}

impl<D, T: Value, A: Writable> Entry<D, T, A> {
    /// The data of an SDO download of `value`.
    #[inline]
    pub fn encode(self, value: T) -> T::Bytes {
        value.to_bytes()
    }
}

impl<D, T: Value, A: Readable> Entry<D, T, A> {
    /// The value in the data of an SDO upload.
    #[inline]
    pub fn decode(self, data: &[u8]) -> Result<T, WrongLength> {
        T::from_slice(data)
    }
}

impl<D, A: Readable> Entry<D, str, A> {
    /// The text in the data of an SDO upload: up to the first zero byte, by which devices pad.
    /// An error says from where on the data is no UTF-8.
    pub fn decode(self, data: &[u8]) -> Result<&str, core::str::Utf8Error> {
        let text = data.split(|byte| *byte == 0).next().unwrap_or_default();
        core::str::from_utf8(text)
    }
}

impl<D, T: ?Sized, A> Clone for Entry<D, T, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, T: ?Sized, A> Copy for Entry<D, T, A> {}

impl<D, T: ?Sized, A> PartialEq for Entry<D, T, A> {
    fn eq(&self, other: &Self) -> bool {
        self.address == other.address
    }
}

impl<D, T: ?Sized, A> Eq for Entry<D, T, A> {}

impl<D, T: ?Sized, A> fmt::Debug for Entry<D, T, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Entry({})", self.address)
    }
}

impl<D, T: ?Sized, A> fmt::Display for Entry<D, T, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.address.fmt(f)
    }
}
