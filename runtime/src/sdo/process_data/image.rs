//! Process data as it is mapped at present, to and from the values of the dictionary.

use super::bits;
use super::current::{Mapped, Place};
use crate::bytes::WrongLength;
use crate::pdo::{Direction, Rx, Tx};
use crate::sdo::values::Scratch;
use crate::sdo::{Found, Hooks, Server, Values, found};

/// Bytes of the longest entry that can be mapped: its width is a number of 8 bits.
const LONGEST: usize = 32;

impl<V: Values, H: Hooks<V>> Server<V, H> {
    /// Takes what a master sent: each entry that is mapped at present is written to its value. Gaps and entries that the
    /// dictionary does not have are passed over; [`Server::mapped`] tells where they lie.
    ///
    /// Values come as they are, as bounds hold for SDOs alone; those of fewer bits than their entry keep their sign.
    pub fn unpack_outputs(&mut self, image: &[u8]) -> Result<(), WrongLength> {
        self.check_len::<Rx>(image.len())?;
        let mut place = Place::first::<Rx>();
        while let Some(mapped) = self.next_mapped(&mut place) {
            let Some(found) = in_dictionary(&self.values, mapped) else { continue };
            let mut value = [0; LONGEST];
            let length = usize::from(found.entry.bytes());
            let Some(value) = value.get_mut(..length) else { continue };
            bits::load(image, mapped.offset, mapped.mapping.bits.into(), value);
            if found.entry.data_type.is_signed() {
                bits::extend(value, mapped.mapping.bits.into());
            }
            if let Some(slot) = found.place().and_then(|place| self.values.slot(place)) {
                // a text that is kept elsewhere cannot be written, by SDO neither
                let _ = slot.store(value);
            }
        }
        Ok(())
    }

    /// Makes what the master is sent: the value of each entry that is mapped at present. Gaps are 0; the bits of entries
    /// that the dictionary does not have stay as they are, for the firmware to fill.
    pub fn pack_inputs(&mut self, image: &mut [u8]) -> Result<(), WrongLength> {
        self.check_len::<Tx>(image.len())?;
        let mut place = Place::first::<Tx>();
        while let Some(mapped) = self.next_mapped(&mut place) {
            let width = mapped.mapping.bits.into();
            let Some(found) = in_dictionary(&self.values, mapped) else {
                if mapped.mapping.is_gap() {
                    bits::store(image, mapped.offset, width, &[]);
                }
                continue;
            };
            let mut scratch = Scratch::default();
            let value = self.value(found, &mut scratch).unwrap_or_default();
            bits::store(image, mapped.offset, width, value);
        }
        Ok(())
    }

    fn check_len<Way: Direction>(&mut self, found: usize) -> Result<(), WrongLength> {
        match self.image_len::<Way>() {
            expected if expected == found => Ok(()),
            expected => Err(WrongLength { expected, found }),
        }
    }
}

fn in_dictionary(values: &impl Values, mapped: Mapped) -> Option<Found> {
    found(values, mapped.mapping.address).ok().filter(|_| !mapped.mapping.is_gap())
}
