//! What a firmware does at a transfer, besides reading and writing a value.

use super::AbortCode;
use crate::object::Address;

/// What happens at transfers of single entries. Each does nothing unless a firmware says otherwise; `()` does nothing
/// at all.
///
/// With [complete access](super::Server::upload_complete) they are called for each entry of the object.
///
/// The server judges by type and bounds. A description may give meanings to single values, but it does not say that
/// there are no others; so which of them are allowed is for the firmware to say:
///
/// ```
/// use devc_runtime::object::Address;
/// use devc_runtime::sdo::{AbortCode, Hooks};
///
/// const MODES_OF_OPERATION: Address = Address::new(0x6060, 0);
///
/// struct Firmware;
///
/// impl<V> Hooks<V> for Firmware {
///     fn before_download(&mut self, _: &mut V, to: Address, data: &[u8]) -> Result<(), AbortCode> {
///         match (to, data) {
///             (MODES_OF_OPERATION, [0 | 1 | 6 | 8]) => Ok(()),
///             (MODES_OF_OPERATION, _) => Err(AbortCode::VALUE_OUT_OF_RANGE),
///             _ => Ok(()),
///         }
///     }
/// }
///
/// let refused = Firmware.before_download(&mut (), MODES_OF_OPERATION, &[3]);
/// assert_eq!(refused, Err(AbortCode(0x0609_0030)));
/// ```
pub trait Hooks<V> {
    /// Before the value is read: the place to compute it. An error refuses the upload.
    fn before_upload(&mut self, _values: &mut V, _address: Address) -> Result<(), AbortCode> {
        Ok(())
    }

    /// Before the value is written: `data` has the right length and is in range, the old value is still in its place.
    /// The place to judge by what the table does not know, and to do what can fail. An error refuses the download,
    /// and the old value stays.
    fn before_download(&mut self, _values: &mut V, _address: Address, _data: &[u8]) -> Result<(), AbortCode> {
        Ok(())
    }

    /// After the value was written: the place to act on it.
    fn after_download(&mut self, _values: &mut V, _address: Address) {}
}

impl<V> Hooks<V> for () {}
