//! What a firmware does at a transfer, besides reading and writing a value.

use super::AbortCode;
use crate::object::Address;

/// What happens at transfers of single entries. Each does nothing unless a firmware says otherwise; `()` does nothing
/// at all.
///
/// With [complete access](super::Server::upload_complete) they are called for each entry of the object.
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
