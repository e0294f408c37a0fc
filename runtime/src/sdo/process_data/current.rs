//! What is mapped at present, as the dictionary says.

use super::judge::number;
use super::role::Way;
use crate::object::Address;
use crate::pdo::{Direction, Mapping, Rx, Tx};
use crate::sdo::values::Scratch;
use crate::sdo::{AbortCode, Hooks, Server, Values, found};

/// An entry in the process data of a direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mapped {
    /// The PDO that it is mapped to, by its mapping object.
    pub pdo: u16,
    /// What is mapped, with its width.
    pub mapping: Mapping,
    /// Its first bit in the process data of the direction. That of a sync manager begins with a byte, behind that of the one
    /// before.
    pub offset: usize,
}

/// Goes through the entries of process data, in the order in which they are transferred.
#[derive(Debug)]
pub struct Current<'s, V, H> {
    server: &'s mut Server<V, H>,
    place: Place,
}

/// How far one has come: to an entry of an assigned PDO.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    way: Way,
    /// Which of the sync managers of the direction.
    carrier: usize,
    /// The subindex of the PDO's index, and of its entry.
    pdo: u8,
    entry: u8,
    offset: usize,
}

impl Place {
    /// Before the first entry of a direction.
    pub(super) const fn first<D: Direction>() -> Self {
        Self { way: Way::of::<D>(), carrier: 0, pdo: 1, entry: 0, offset: 0 }
    }

    /// Before the first entry of the next sync manager.
    const fn next_carrier(&mut self) {
        (self.carrier, self.pdo, self.entry) = (self.carrier.saturating_add(1), 1, 0);
        self.offset = self.offset.next_multiple_of(8);
    }
}

impl<V: Values, H: Hooks<V>> Server<V, H> {
    /// What is mapped at present to the PDOs that are assigned at present, with where it lies. Entries that the dictionary
    /// does not have are among it, and gaps.
    pub fn mapped<Way: Direction>(&mut self) -> Current<'_, V, H> {
        Current { server: self, place: Place::first::<Way>() }
    }

    /// The present length of the process data of a direction, in bytes.
    pub fn image_len<Way: Direction>(&mut self) -> usize {
        let bits =
            self.mapped::<Way>().fold(0, |_, last| last.offset.saturating_add(last.mapping.bits.into()));
        bits.div_ceil(8)
    }

    /// The present bytes of process data of each sync manager, by number: what the PDOs have that are assigned to it by the
    /// object of its number, 0x1C10 and up. A mailbox carries none.
    ///
    /// ```ignore
    /// machine.request(control, &managers, &server.carried::<4>(), &mut application);
    /// ```
    pub fn carried<const N: usize>(&mut self) -> [usize; N] {
        let mut lengths = [0; N];
        for (length, assignment) in lengths.iter_mut().zip(0x1C10..) {
            *length = self.carried_by(assignment);
        }
        lengths
    }

    /// Those of one sync manager, by its assignment object.
    pub(super) fn carried_by(&mut self, assignment: u16) -> usize {
        let Some((way, carrier)) = self.carrier(assignment) else { return 0 };
        let mut place = Place { way, carrier, pdo: 1, entry: 0, offset: 0 };
        while self.next_assigned(assignment, &mut place).is_some() {}
        place.offset.div_ceil(8)
    }

    /// Which way a sync manager carries process data, and which one of that way it is.
    fn carrier(&self, assignment: u16) -> Option<(Way, usize)> {
        [Way::Rx, Way::Tx].into_iter().find_map(|way| {
            let mut carriers = (0..).map_while(|carrier| self.assignment(way, carrier));
            Some((way, carriers.position(|other| other == assignment)?))
        })
    }

    /// The assignment object of a sync manager of a direction; without rules there is one, with its usual number.
    fn assignment(&self, way: Way, carrier: usize) -> Option<u16> {
        match self.values.process_data() {
            Some(rules) => rules.assignments(way).nth(carrier),
            None if carrier > 0 => None,
            None => Some(if way == Way::Rx { Rx::ASSIGNMENT } else { Tx::ASSIGNMENT }),
        }
    }

    /// The present length of a PDO in bits.
    pub(super) fn bits_of(&mut self, pdo: u16) -> Result<usize, AbortCode> {
        let count = u8::try_from(self.number(Address::new(pdo, 0))?).unwrap_or(u8::MAX);
        let mut bits = 0_usize;
        for subindex in 1..=count {
            let mapping = Mapping::from_word(self.number(Address::new(pdo, subindex))?);
            bits = bits.saturating_add(mapping.bits.into());
        }
        Ok(bits)
    }

    /// The present value of an entry that is a number of at most 32 bits.
    pub(super) fn number(&mut self, address: Address) -> Result<u32, AbortCode> {
        Ok(number(self.value(found(&self.values, address)?, &mut Scratch::default())?))
    }

    /// The next entry; none behind the last.
    pub(super) fn next_mapped(&mut self, place: &mut Place) -> Option<Mapped> {
        while let Some(assignment) = self.assignment(place.way, place.carrier) {
            if let Some(mapped) = self.next_assigned(assignment, place) {
                return Some(mapped);
            }
            place.next_carrier();
        }
        None
    }

    /// The next entry of a sync manager; none behind the last, or where the dictionary does not have what it should.
    fn next_assigned(&mut self, assignment: u16, place: &mut Place) -> Option<Mapped> {
        let pdos = self.number(Address::new(assignment, 0)).ok()?;
        while u32::from(place.pdo) <= pdos {
            let pdo = u16::try_from(self.number(Address::new(assignment, place.pdo)).ok()?).ok()?;
            let entries = self.number(Address::new(pdo, 0)).unwrap_or(0);
            if u32::from(place.entry) < entries {
                place.entry = place.entry.checked_add(1)?;
                let mapping = Mapping::from_word(self.number(Address::new(pdo, place.entry)).ok()?);
                let offset = place.offset;
                place.offset = offset.saturating_add(mapping.bits.into());
                return Some(Mapped { pdo, mapping, offset });
            }
            (place.pdo, place.entry) = (place.pdo.checked_add(1)?, 0);
        }
        None
    }
}

impl<V: Values, H: Hooks<V>> Iterator for Current<'_, V, H> {
    type Item = Mapped;

    fn next(&mut self) -> Option<Mapped> {
        self.server.next_mapped(&mut self.place)
    }
}
