//! Process data by value.

use super::Direction;
use crate::bytes::{ByteArray, WrongLength};

/// Data that goes in a frame each cycle: a PDO, or all PDOs of a direction one after the other.
///
/// Arrays cannot have a wrong length; slices can, and the slice methods find it out with one comparison.
///
/// ```
/// use devc_runtime::pdo::{ProcessData, Rx};
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
/// devc_runtime::process_data!(Target: C887, Rx, 6);
///
/// let mut frame = [0; 6];
/// let target = Target { controlword: 0x000F, position: -1 };
/// assert_eq!(target.pack_into(&mut frame), Ok(()));
/// assert_eq!(frame, [0x0F, 0x00, 0xFF, 0xFF, 0xFF, 0xFF]);
/// assert_eq!(Target::unpack_from(&frame), Ok(target));
/// assert!(Target::unpack_from(&frame[1..]).is_err());
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no process data of a device",
    note = "PDOs are in the module of a device, or structs with `#[derive(Pdo)]`"
)]
pub trait ProcessData: Copy {
    /// The device whose data this is, or the family of devices that have it.
    type Device;
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

/// Implements [`ProcessData`](crate::pdo::ProcessData) for a struct that packs and unpacks itself by `const fn` `pack` and
/// `unpack`: the struct, its device, its direction and its bytes. With the feature `ethercrab` it gets the traits of
/// that master, too.
#[macro_export]
macro_rules! process_data {
    ($data:ident: $device:ty, $direction:ty, $length:expr) => {
        impl $crate::pdo::ProcessData for $data {
            type Device = $device;
            type Direction = $direction;
            type Image = [u8; $length];

            #[inline]
            fn pack(self) -> [u8; $length] {
                self.pack()
            }

            #[inline]
            fn unpack(image: [u8; $length]) -> Self {
                Self::unpack(image)
            }
        }

        $crate::ethercrab!($data, $length);
    };
}
