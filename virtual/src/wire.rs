//! Subdevices one behind the other.

use std::time::Duration;

use crate::event::Event;
use crate::frame::{Datagram, Target, datagrams, mark_returned};
use crate::{Firmware, Subdevice};

/// How many complaints that belong to no subdevice are kept apart before they are told again.
const KEPT: usize = 64;

/// A wire with subdevices, each at its position: from the master through all of them, and back.
///
/// It has no clock: whoever owns it lets time go on by [`Wire::advance`], so that a test can take as long as it likes.
#[derive(Debug)]
pub struct Wire<F> {
    subdevices: Vec<Subdevice<F>>,
    events: Vec<Event>,
    /// Complaints that were told, so that what a master does in each cycle is told once.
    told: Vec<(Option<usize>, Event)>,
}

impl<F: Firmware> Wire<F> {
    /// A wire with these subdevices; the first is next to the master.
    pub fn new(subdevices: Vec<Subdevice<F>>) -> Self {
        let mut wire = Self { subdevices, events: Vec::new(), told: Vec::new() };
        let count = wire.subdevices.len();
        for (position, subdevice) in wire.subdevices.iter_mut().enumerate() {
            subdevice.place(position, count);
        }
        wire
    }

    /// The subdevices, by position.
    pub fn subdevices(&self) -> &[Subdevice<F>] {
        &self.subdevices
    }

    /// The subdevices, by position.
    pub fn subdevices_mut(&mut self) -> &mut [Subdevice<F>] {
        &mut self.subdevices
    }

    /// Lets an Ethernet frame pass, which is then as it comes back to the master. Tells whether it is one of EtherCAT; if not
    /// it stays as it is, and does not come back.
    pub fn pass(&mut self, frame: &mut [u8]) -> bool {
        let Some(datagrams) = datagrams(frame) else { return false };
        for datagram in datagrams {
            self.pass_datagram(datagram);
        }
        if !self.subdevices.is_empty() {
            mark_returned(frame);
        }
        true
    }

    fn pass_datagram(&mut self, mut datagram: Datagram<'_>) {
        let (subdevice, logical) = (datagram.subdevice(), datagram.logical());
        let mut is_addressed = false;
        for subdevice in &mut self.subdevices {
            is_addressed |= subdevice.pass(&mut datagram);
        }
        if is_addressed || datagram.working_counter() != 0 {
            return;
        }
        let event = match datagram.command.map(|command| command.target) {
            Some(Target::Position) => Event::NoPosition { position: subdevice.wrapping_neg() },
            Some(Target::Station) => Event::NoStation { station: subdevice },
            Some(Target::Logical) => Event::Unmapped { address: logical, length: datagram.data.len() },
            Some(Target::Broadcast) | None => return,
        };
        if self.events.len() < KEPT {
            self.events.push(event);
        }
    }

    /// Time goes on, and every firmware does what there is to do.
    pub fn advance(&mut self, elapsed: Duration) {
        self.elapse(elapsed);
        self.work();
    }

    /// Time goes on for the controllers: to be told before a frame passes, as clocks tell when it did.
    pub fn elapse(&mut self, elapsed: Duration) {
        self.subdevices.iter_mut().for_each(|subdevice| subdevice.elapse(elapsed));
    }

    /// Every firmware does what there is to do: to be called when a frame has passed.
    pub fn work(&mut self) {
        self.subdevices.iter_mut().for_each(Subdevice::work);
    }

    /// What has happened since this was asked for last: at which position, if at one. What a master goes on doing wrong is
    /// told once, until the state of a subdevice changes.
    pub fn take_events(&mut self) -> Vec<(Option<usize>, Event)> {
        let of_wire = std::mem::take(&mut self.events).into_iter().map(|event| (None, event));
        let mut events: Vec<_> = of_wire.collect();
        for (position, subdevice) in self.subdevices.iter_mut().enumerate() {
            events.extend(subdevice.take_events().into_iter().map(|event| (Some(position), event)));
        }
        events.retain(|event| {
            if !event.1.is_complaint() {
                self.told.clear();
                return true;
            }
            let is_new = !self.told.contains(event);
            if is_new {
                self.told.truncate(KEPT - 1);
                self.told.insert(0, event.clone());
            }
            is_new
        });
        events
    }
}
