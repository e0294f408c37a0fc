//! What stands behind the EtherCAT subdevice controller.

use std::time::Duration;

use devc_runtime::esm::{AlControl, AlStatus, AlStatusCode, Areas, Configured, Lengths};

use crate::{Clocks, Event};

/// The firmware of a device, as its EtherCAT subdevice controller (ESC) sees it: the controller has the memory, the
/// sync managers and the wire; the firmware has the states, the mailbox and what process data means.
pub trait Firmware {
    /// A master wrote AL control. `managers` are the settings of the sync managers at that moment, in the order of their roles.
    fn request(&mut self, control: AlControl, managers: &[Configured; 4]);

    /// What a master has set of the distributed clocks, told before each request. It makes nothing of them unless it says
    /// otherwise.
    fn clocked(&mut self, _clocks: Clocks) {}

    /// What the sync managers have to be: where they may lie, and the present lengths of process data. A master is told by it
    /// what is wrong with its settings.
    fn expected(&mut self) -> (Areas, Lengths);

    /// Which sync manager each role has, in the order of settings: mailbox from and to the master, outputs, inputs. It is the
    /// usual order unless it says otherwise; a role that there is not has a number beyond all.
    fn numbers(&self) -> [usize; 4] {
        [0, 1, 2, 3]
    }

    /// What AL status and AL status code show.
    fn status(&self) -> (AlStatus, AlStatusCode);

    /// A master wrote a message into the mailbox: writes the answer and tells its length, 0 if there is none. `answer` is
    /// as long as the sync manager of mail to the master.
    fn mail(&mut self, message: &[u8], answer: &mut [u8]) -> usize;

    /// The master has read the last message, and the mailbox is free: the next piece of an answer, or an emergency. Its
    /// length, 0 if there is nothing to say.
    fn more_mail(&mut self, answer: &mut [u8]) -> usize;

    /// New process data from the master.
    fn outputs(&mut self, image: &[u8]);

    /// The process data for the master, as it is now.
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
    fn request(&mut self, control: AlControl, managers: &[Configured; 4]) {
        (**self).request(control, managers);
    }

    fn clocked(&mut self, clocks: Clocks) {
        (**self).clocked(clocks);
    }

    fn expected(&mut self) -> (Areas, Lengths) {
        (**self).expected()
    }

    fn numbers(&self) -> [usize; 4] {
        (**self).numbers()
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
