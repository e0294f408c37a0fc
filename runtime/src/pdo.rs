//! Process data (CiA 301, PDO; ETG.1000.6, PDO).
//!
//! Each PDO is generated as a struct with a field for each mapped entry. Its `pack` is one array literal of all bytes
//! and its `unpack` one array pattern: no offset, no loop and so no check that could fail, at any optimisation level.

use crate::Device;
use crate::bytes::{ByteArray, WrongLength};

mod sealed {
    pub trait Sealed {}
}

/// Which way process data goes, seen from the device.
pub trait Direction: sealed::Sealed {
    /// The object whose subindices name the PDOs in use: that of sync manager 2 or 3 (ETG.1000.6).
    const ASSIGNMENT: u16;
}

/// Received by the device: the outputs of the master.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rx {}

/// Transmitted by the device: the inputs of the master.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tx {}

impl sealed::Sealed for Rx {}
impl sealed::Sealed for Tx {}

impl Direction for Rx {
    const ASSIGNMENT: u16 = 0x1C12;
}

impl Direction for Tx {
    const ASSIGNMENT: u16 = 0x1C13;
}

/// Data that goes in a frame each cycle: a PDO, or all PDOs of a direction one after the other.
///
/// Arrays cannot have a wrong length; slices can, and the slice methods find it out with one comparison.
///
/// ```
/// # use devc_runtime::pdo::{ProcessData, Rx};
/// # use devc_runtime::Device;
/// # #[derive(Debug, Clone, Copy)]
/// # struct C887;
/// # impl Device for C887 {
/// #     const NAME: &'static str = "C-887.53x";
/// #     const VENDOR_ID: u32 = 0x076D;
/// #     const PRODUCT_CODE: u32 = 3;
/// #     const REVISION: u32 = 0;
/// # }
/// #[derive(Debug, Clone, Copy, PartialEq)]
/// struct Target {
///     controlword: u16,
///     position: i32,
/// }
///
/// impl Target {
///     const fn pack(self) -> [u8; 6] {
///         let [c0, c1] = self.controlword.to_le_bytes();
///         let [p0, p1, p2, p3] = self.position.to_le_bytes();
///         [c0, c1, p0, p1, p2, p3]
///     }
///
///     const fn unpack([c0, c1, p0, p1, p2, p3]: [u8; 6]) -> Self {
///         Self { controlword: u16::from_le_bytes([c0, c1]), position: i32::from_le_bytes([p0, p1, p2, p3]) }
///     }
/// }
///
/// impl ProcessData for Target {
///     type Device = C887;
///     type Direction = Rx;
///     type Image = [u8; 6];
///     fn pack(self) -> [u8; 6] { self.pack() }
///     fn unpack(image: [u8; 6]) -> Self { Self::unpack(image) }
/// }
///
/// let mut frame = [0; 6];
/// let target = Target { controlword: 0x000F, position: -1 };
/// assert_eq!(target.pack_into(&mut frame), Ok(()));
/// assert_eq!(frame, [0x0F, 0x00, 0xFF, 0xFF, 0xFF, 0xFF]);
/// assert_eq!(Target::unpack_from(&frame), Ok(target));
/// assert!(Target::unpack_from(&frame[1..]).is_err());
/// ```
pub trait ProcessData: Copy {
    /// The device whose data this is.
    type Device: Device;
    /// Which way the data goes.
    type Direction: Direction;
    /// The bytes in the frame.
    type Image: ByteArray;

    /// Number of bytes in the frame.
    const LEN: usize = <Self::Image as ByteArray>::LEN;

    /// The bytes of the fields, in the order of the mapping.
    fn pack(self) -> Self::Image;

    /// The fields from their bytes. Every combination of bytes is a value.
    fn unpack(image: Self::Image) -> Self;

    /// Packs into the part of a frame that belongs to this data; it has to be just as long.
    #[inline]
    fn pack_into(self, frame: &mut [u8]) -> Result<(), WrongLength> {
        *Self::Image::from_slice_mut(frame)? = self.pack();
        Ok(())
    }

    /// Unpacks from the part of a frame that belongs to this data; it has to be just as long.
    #[inline]
    fn unpack_from(frame: &[u8]) -> Result<Self, WrongLength> {
        Self::Image::from_slice(frame).map(|image| Self::unpack(*image))
    }
}

/// A single PDO: process data that has an index of its own.
///
/// Where each axis has a PDO of the same shape, there is one type for all, so that a program can go through the axes;
/// the constants are those of the first axis, and the generated type tells the others.
pub trait Pdo: ProcessData {
    /// The mapping object, 0x1600 on for received and 0x1A00 on for transmitted PDOs (CiA 301).
    const INDEX: u16;
    /// What is mapped, in order, each as the mapping object holds it: index, subindex and number of bits.
    const MAPPING: &'static [Mapping];
}

/// A mapped entry: what a subindex of a mapping object says (CiA 301, PDO mapping).
///
/// ```
/// use devc_runtime::object::Address;
/// use devc_runtime::pdo::Mapping;
///
/// let target_position = Mapping { address: Address::new(0x607A, 0), bits: 32 };
/// assert_eq!(target_position.word(), 0x607A_0020);
/// assert_eq!(Mapping::from_word(0x607A_0020), target_position);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mapping {
    /// The entry; index 0 stands for a gap.
    pub address: crate::object::Address,
    /// Its length in bits.
    pub bits: u8,
}

impl Mapping {
    /// Index, subindex and length in one number, the value of the mapping object's subindex.
    pub const fn word(self) -> u32 {
        let [high, low] = self.address.index.to_be_bytes();
        u32::from_be_bytes([high, low, self.address.subindex, self.bits])
    }

    /// The entry that a mapping object's subindex names.
    pub const fn from_word(word: u32) -> Self {
        let [high, low, subindex, bits] = word.to_be_bytes();
        Self { address: crate::object::Address::new(u16::from_be_bytes([high, low]), subindex), bits }
    }
}
