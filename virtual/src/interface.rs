//! A network interface with a wire at it.

use std::io;
use std::os::fd::AsRawFd;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration as Time;

use smoltcp::phy::{Device, Medium, RawSocket, RxToken, TxToken, wait};
use smoltcp::time::{Duration, Instant};

/// The Ethernet frames of a network interface, all that come and none that go: the kernel does not give a socket what it has
/// sent itself.
#[derive(Debug)]
pub struct Interface {
    socket: RawSocket,
}

impl Interface {
    /// The interface with this name. Takes the right to open raw sockets, as root has it.
    pub fn open(name: &str) -> io::Result<Self> {
        Ok(Self { socket: RawSocket::new(name, Medium::Ethernet)? })
    }

    /// Waits for a frame for so long at most.
    pub fn wait(&self, timeout: Time) -> io::Result<()> {
        let micros = u64::try_from(timeout.as_micros()).unwrap_or(u64::MAX);
        match wait(self.socket.as_raw_fd(), Some(Duration::from_micros(micros))) {
            // a signal has come, which is for others
            Err(error) if error.kind() == io::ErrorKind::Interrupted => Ok(()),
            waited => waited,
        }
    }

    /// The next frame, if one has come.
    pub fn receive(&mut self) -> io::Result<Option<Vec<u8>>> {
        let frame = unless_gone(|| {
            let (frame, _) = self.socket.receive(Instant::ZERO)?;
            Some(frame.consume(<[u8]>::to_vec))
        })?;
        Ok(frame)
    }

    /// Sends a frame.
    pub fn send(&mut self, frame: &[u8]) -> io::Result<()> {
        unless_gone(|| {
            if let Some(token) = self.socket.transmit(Instant::ZERO) {
                token.consume(frame.len(), |place| place.copy_from_slice(frame));
            }
        })
    }
}

/// The socket of smoltcp panics with the error of the kernel, as when the interface is taken away or goes down.
fn unless_gone<R>(access: impl FnOnce() -> R) -> io::Result<R> {
    catch_unwind(AssertUnwindSafe(access)).map_err(|panic| {
        let told = panic.downcast_ref::<String>().cloned();
        io::Error::other(told.unwrap_or_else(|| "the network interface cannot be used any more".to_owned()))
    })
}
