//! What stands behind the EtherCAT subdevice controller.

use std::time::Duration;

use devc_runtime::esm::{AlControl, AlStatus, AlStatusCode, Areas, Configured};

use crate::{Clocks, Event};

/// The firmware of a device, as its EtherCAT subdevice controller (ESC) sees it: the controller has the memory, the
/// sync managers and the wire; the firmware has the states, the mailbox and what process data means.
pub trait Firmware {
    /// A master wrote AL control. `managers` are the settings of the sync managers at that moment, by number.
    fn request(&mut self, control: AlControl, managers: &[Configured]);

    /// What a master has set of the distributed clocks, told before each request. It makes nothing of them unless it says
    /// otherwise.
    fn clocked(&mut self, _clocks: Clocks) {}

    /// What the sync managers have to be: which there are and where they may lie, and the present bytes of process data in each,
    /// by number. A master is told by it what is wrong with its settings.
    fn expected(&mut self) -> (Areas, Vec<usize>);

    /// What AL status and AL status code show.
    fn status(&self) -> (AlStatus, AlStatusCode);

    /// A master wrote a message into the mailbox: writes the answer and tells its length, 0 if there is none. `answer` is
    /// as long as the sync manager of mail to the master.
    fn mail(&mut self, message: &[u8], answer: &mut [u8]) -> usize;

    /// The master has read the last message, and the mailbox is free: the next piece of an answer, or an emergency. Its
    /// length, 0 if there is nothing to say.
    fn more_mail(&mut self, answer: &mut [u8]) -> usize;

    /// New process data from the master: what its sync managers carry, one behind the other.
    fn outputs(&mut self, image: &[u8]);

    /// The process data for the master, as it is now, for its sync managers one behind the other.
    fn inputs(&mut self, image: &mut [u8]);

    /// No outputs came in the time of the watchdog.
    fn watchdog_expired(&mut self);

    /// Time goes on.
    fn step(&mut self, elapsed: Duration);

    /// What it has to say of what a master did, since it was asked last.
    fn take_events(&mut self) -> Vec<Event> {
        Vec::new()
    }
}

impl<F: Firmware + ?Sized> Firmware for Box<F> {
    fn request(&mut self, control: AlControl, managers: &[Configured]) {
        (**self).request(control, managers);
    }

    fn clocked(&mut self, clocks: Clocks) {
        (**self).clocked(clocks);
    }

    fn expected(&mut self) -> (Areas, Vec<usize>) {
        (**self).expected()
    }

    fn status(&self) -> (AlStatus, AlStatusCode) {
        (**self).status()
    }

    fn mail(&mut self, message: &[u8], answer: &mut [u8]) -> usize {
        (**self).mail(message, answer)
    }

    fn more_mail(&mut self, answer: &mut [u8]) -> usize {
        (**self).more_mail(answer)
    }

    fn outputs(&mut self, image: &[u8]) {
        (**self).outputs(image);
    }

    fn inputs(&mut self, image: &mut [u8]) {
        (**self).inputs(image);
    }

    fn watchdog_expired(&mut self) {
        (**self).watchdog_expired();
    }

    fn step(&mut self, elapsed: Duration) {
        (**self).step(elapsed);
    }

    fn take_events(&mut self) -> Vec<Event> {
        (**self).take_events()
    }
}
