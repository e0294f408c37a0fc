//! Frames in a file that Wireshark opens.

use std::io::{self, Write};
use std::time::Duration;

/// Which way a frame goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// From the master.
    In,
    /// Back to the master.
    Out,
}

/// A trace in the format pcapng (draft-ietf-opsawg-pcapng): Ethernet frames with the way they went, and with times in
/// nanoseconds.
#[derive(Debug)]
pub struct Trace<W> {
    file: W,
}

const SECTION: u32 = 0x0A0D_0D0A;
const INTERFACE: u32 = 1;
const PACKET: u32 = 6;
const COMMENT: u16 = 1;
const NAME: u16 = 2;
const RESOLUTION: u16 = 9;
const FLAGS: u16 = 2;
/// Ethernet, and no limit of length.
const ETHERNET: [u8; 8] = [1, 0, 0, 0, 0, 0, 0, 0];

impl<W: Write> Trace<W> {
    /// Begins a trace of an interface, with words about it.
    pub fn begin(mut file: W, interface: &str, comment: &str) -> io::Result<Self> {
        let mut section = Vec::new();
        section.extend(0x1A2B_3C4D_u32.to_le_bytes());
        // version 1.0, of a length that is not told
        section.extend([1, 0, 0, 0]);
        section.extend(u64::MAX.to_le_bytes());
        option(&mut section, COMMENT, comment.as_bytes());
        option(&mut section, 0, &[]);
        block(&mut file, SECTION, &section)?;
        let mut description = ETHERNET.to_vec();
        option(&mut description, NAME, interface.as_bytes());
        option(&mut description, RESOLUTION, &[9]);
        option(&mut description, 0, &[]);
        block(&mut file, INTERFACE, &description)?;
        Ok(Self { file })
    }

    /// Adds a frame, with the time since 1970.
    pub fn frame(&mut self, at: Duration, way: Way, frame: &[u8]) -> io::Result<()> {
        let nanoseconds = u64::try_from(at.as_nanos()).unwrap_or(u64::MAX);
        let length = u32::try_from(frame.len()).map_err(io::Error::other)?;
        let mut packet = vec![0; 4];
        packet.extend(u32::try_from(nanoseconds >> 32).unwrap_or(u32::MAX).to_le_bytes());
        packet.extend(u32::try_from(nanoseconds & 0xFFFF_FFFF).unwrap_or(u32::MAX).to_le_bytes());
        packet.extend(length.to_le_bytes());
        packet.extend(length.to_le_bytes());
        packet.extend(frame);
        fill(&mut packet);
        let way: u32 = match way {
            Way::In => 1,
            Way::Out => 2,
        };
        option(&mut packet, FLAGS, &way.to_le_bytes());
        option(&mut packet, 0, &[]);
        block(&mut self.file, PACKET, &packet)
    }

    /// Lets all that was added arrive in the file.
    pub fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A block of a kind: its length before and behind it.
fn block(file: &mut impl Write, kind: u32, body: &[u8]) -> io::Result<()> {
    let length = u32::try_from(body.len() + 12).map_err(io::Error::other)?;
    file.write_all(&kind.to_le_bytes())?;
    file.write_all(&length.to_le_bytes())?;
    file.write_all(body)?;
    file.write_all(&length.to_le_bytes())
}

/// An option of a kind; what does not fit is cut off.
fn option(block: &mut Vec<u8>, kind: u16, value: &[u8]) {
    let value = value.get(..usize::from(u16::MAX)).unwrap_or(value);
    block.extend(kind.to_le_bytes());
    block.extend(u16::try_from(value.len()).unwrap_or(u16::MAX).to_le_bytes());
    block.extend(value);
    fill(block);
}

/// All in a block begins at multiples of four bytes.
fn fill(block: &mut Vec<u8>) {
    block.resize(block.len().next_multiple_of(4), 0);
}
