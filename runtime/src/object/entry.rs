//! Entries with everything that the compiler can check about them.

use core::fmt;
use core::marker::PhantomData;

use super::{Address, Marker, Readable, Value, Writable};
use crate::bytes::WrongLength;
use crate::pdo::Unmapped;
use crate::sdo::Access;
use crate::unit::Measurand;

/// An entry of the dictionary of device `D`, of Rust type `T` (`str` for a visible string), with access `A`, that may be
/// in PDOs of direction `M`, and whose values measure `Q`, if anything.
///
/// It is no more than its address, and the ratio of its unit, at run time. Generated code has one constant for each
/// entry:
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
/// ```compile_fail,E0599
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
pub struct Entry<D, T: ?Sized, A, M = Unmapped, Q: Measurand = ()> {
    address: Address,
    unit: Q::Unit<D>,
    checked: PhantomData<(D, A, M, T)>,
}

impl<D, T: ?Sized, A, M> Entry<D, T, A, M> {
    /// The entry at `index`:`subindex`. Types are promised here and relied on everywhere else, so this is for
    /// generated code.
    pub const fn new(index: u16, subindex: u8) -> Self {
        Self { address: Address::new(index, subindex), unit: (), checked: PhantomData }
    }

    /// The entry with the unit of its values, for generated code as well.
    pub const fn measured_in<Q: Measurand>(self, unit: Q::Unit<D>) -> Entry<D, T, A, M, Q> {
        Entry { address: self.address, unit, checked: PhantomData }
    }
}

impl<D, T: ?Sized, A, M, Q: Measurand> Entry<D, T, A, M, Q> {
    /// Where the entry is.
    pub const fn address(self) -> Address {
        self.address
    }

    /// The unit of its values, in SDOs as in the fields of process data: a PDO carries the value of the object (CiA 301,
    /// PDO mapping).
    pub const fn unit(self) -> Q::Unit<D> {
        self.unit
    }
}

impl<D, T: ?Sized, A: Marker, M, Q: Measurand> Entry<D, T, A, M, Q> {
    /// The access to the entry at run time, not counting that it may depend on the communication state.
    pub const fn access(self) -> Access {
        A::ACCESS
    }
}

impl<D, T: Value, A: Writable, M, Q: Measurand> Entry<D, T, A, M, Q> {
    /// The data of an SDO download of `value`.
    #[inline]
    pub fn encode(self, value: T) -> T::Bytes {
        value.to_bytes()
    }
}

impl<D, T: Value, A: Readable, M, Q: Measurand> Entry<D, T, A, M, Q> {
    /// The value in the data of an SDO upload.
    #[inline]
    pub fn decode(self, data: &[u8]) -> Result<T, WrongLength> {
        T::from_slice(data)
    }
}

impl<D, A: Readable, M, Q: Measurand> Entry<D, str, A, M, Q> {
    /// The text in the data of an SDO upload: up to the first zero byte, by which devices pad.
    /// An error says from where on the data is no UTF-8.
    pub fn decode(self, data: &[u8]) -> Result<&str, core::str::Utf8Error> {
        let text = data.split(|byte| *byte == 0).next().unwrap_or_default();
        core::str::from_utf8(text)
    }
}

impl<D, T: ?Sized, A, M, Q: Measurand> Clone for Entry<D, T, A, M, Q> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, T: ?Sized, A, M, Q: Measurand> Copy for Entry<D, T, A, M, Q> {}

impl<D, T: ?Sized, A, M, Q: Measurand> PartialEq for Entry<D, T, A, M, Q> {
    fn eq(&self, other: &Self) -> bool {
        self.address == other.address
    }
}

impl<D, T: ?Sized, A, M, Q: Measurand> Eq for Entry<D, T, A, M, Q> {}

impl<D, T: ?Sized, A, M, Q: Measurand> fmt::Debug for Entry<D, T, A, M, Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Entry({})", self.address)
    }
}

impl<D, T: ?Sized, A, M, Q: Measurand> fmt::Display for Entry<D, T, A, M, Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.address.fmt(f)
    }
}
