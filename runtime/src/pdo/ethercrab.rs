//! The traits of `ethercrab-wire` 0.3, in terms of [`ProcessData`]: process data drops into that master.

pub use ethercrab_wire::{
    EtherCrabWireRead, EtherCrabWireSized, EtherCrabWireWrite, EtherCrabWireWriteSized, WireError,
};

use super::ProcessData;

/// Unpacks from the beginning of a buffer, which may be longer.
pub fn unpack<P: ProcessData>(buffer: &[u8]) -> Result<P, WireError> {
    let image = buffer.get(..P::LEN).ok_or(WireError::ReadBufferTooShort)?;
    P::unpack_from(image).map_err(|_| WireError::ArrayLength)
}

/// Packs into the beginning of a buffer, which may be longer.
///
/// # Panics
///
/// If the buffer is shorter: that is what the trait asks for.
#[track_caller]
pub fn pack<P: ProcessData>(data: P, buffer: &mut [u8]) -> &[u8] {
    let (image, _) = buffer.split_at_mut(P::LEN);
    image.copy_from_slice(data.pack().as_ref());
    image
}

/// Implements the traits for process data of so many bytes.
#[doc(hidden)]
#[macro_export]
macro_rules! ethercrab {
    ($data:ident, $length:expr) => {
        impl $crate::pdo::ethercrab::EtherCrabWireRead for $data {
            fn unpack_from_slice(buffer: &[u8]) -> Result<Self, $crate::pdo::ethercrab::WireError> {
                $crate::pdo::ethercrab::unpack(buffer)
            }
        }

        impl $crate::pdo::ethercrab::EtherCrabWireWrite for $data {
            fn pack_to_slice_unchecked<'b>(&self, buffer: &'b mut [u8]) -> &'b [u8] {
                $crate::pdo::ethercrab::pack(*self, buffer)
            }

            fn packed_len(&self) -> usize {
                $length
            }
        }

        impl $crate::pdo::ethercrab::EtherCrabWireSized for $data {
            const PACKED_LEN: usize = $length;
            type Buffer = [u8; $length];

            fn buffer() -> [u8; $length] {
                [0; $length]
            }
        }

        impl $crate::pdo::ethercrab::EtherCrabWireWriteSized for $data {
            fn pack(&self) -> [u8; $length] {
                $crate::pdo::ProcessData::pack(*self)
            }
        }
    };
}
