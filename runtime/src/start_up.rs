//! Bring-up: what a master writes through the mailbox before it goes to Safe-Operational, as constant data.
//!
//! The order is that of ETG.1020: assignments are cleared before mappings change, and a count is written after what
//! it counts. What the device does not let a master write is not in a list.

mod bring_up;
mod cycle;
mod list;

use core::fmt;

use crate::Family;
use crate::object::Address;
use crate::pdo::{Direction, MappedPdo, ProcessImage, Rx, Tx, refuse};
use crate::text::Text;

pub use bring_up::{AxisObjects, BringUp};
pub use cycle::CycleLimit;
use list::List;

/// A write through the mailbox: an SDO download on the way to process data.
///
/// ```
/// use devc_runtime::object::Address;
/// use devc_runtime::start_up::Write;
///
/// const CLEAR: Write = Write::new(Address::new(0x1C12, 0), &[0], "clear the assignment");
/// assert_eq!(CLEAR.data(), [0]);
/// assert_eq!(CLEAR.to_string(), "0x1C12:00 = 0x00, clear the assignment");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Write {
    /// Where to.
    pub address: Address,
    /// What for.
    pub what: &'static str,
    /// The change of the EtherCAT state at which it is made, by the names of its states: `"PS"` from Pre-Operational to
    /// Safe-Operational.
    pub transition: &'static str,
    data: [u8; 8],
    length: usize,
}

impl Write {
    /// A write of the first eight bytes of the data, as they travel, from Pre-Operational to Safe-Operational.
    pub const fn new(address: Address, data: &[u8], what: &'static str) -> Self {
        let mut write = Self { address, what, transition: "PS", data: [0; 8], length: 0 };
        let (mut places, mut bytes): (&mut [u8], _) = (&mut write.data, data);
        while let (Some((place, others)), Some((byte, rest))) =
            (places.split_first_mut(), bytes.split_first())
        {
            *place = *byte;
            write.length += 1;
            (places, bytes) = (others, rest);
        }
        write
    }

    /// The same at another change of the EtherCAT state.
    pub const fn during(mut self, transition: &'static str) -> Self {
        self.transition = transition;
        self
    }

    /// The data, as it travels: little-endian.
    pub const fn data(&self) -> &[u8] {
        match self.data.split_at_checked(self.length) {
            Some((data, _)) => data,
            None => &[],
        }
    }
}

impl fmt::Display for Write {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = 0x", self.address)?;
        for byte in self.data().iter().rev() {
            write!(f, "{byte:02X}")?;
        }
        write!(f, ", {}", self.what)
    }
}

/// What a master chooses: process data, and if need be mode and cycle time. The list follows from it, while the code
/// is compiled:
///
/// ```ignore
/// const CHOICE: StartUp = StartUp::of::<Outputs, Inputs>().mode(8).cycle_ns::<2_000_000>();
/// const LIST: [Write; CHOICE.len()] = CHOICE.writes();
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StartUp {
    outputs: Option<&'static [MappedPdo]>,
    inputs: Option<&'static [MappedPdo]>,
    maps: bool,
    axes: &'static [AxisObjects],
    /// The devices that the choice may be for, and which of them take it, a bit each.
    devices: &'static [BringUp],
    takers: u64,
    mode: Option<i8>,
    /// 0x60C2: a count of units of 10 to the power of the other, in seconds.
    cycle: Option<(u8, i8)>,
}

impl StartUp {
    /// The process data of both directions. Where several members of a family take it, they have to be brought up
    /// alike: else the list is made [`on`](Self::on) one of them.
    #[track_caller]
    pub const fn of<O, I>() -> Self
    where
        O: ProcessImage<Direction = Rx>,
        I: ProcessImage<Direction = Tx, Device = O::Device>,
        O::Device: Family,
    {
        let (mut members, mut found) = (<O::Device as Family>::MEMBERS, None);
        let (mut takers, mut place) = (0, 1);
        while let Some((member, rest)) = members.split_first() {
            if member.takes::<O>() && member.takes::<I>() {
                takers |= place;
                match found {
                    Some(first) if !member.is_like::<O, I>(first) => refuse(member.differs(first)),
                    Some(_) => {}
                    None => found = Some(member),
                }
            }
            (members, place) = (rest, place << 1);
        }
        match found {
            Some(member) => {
                Self { devices: <O::Device as Family>::MEMBERS, takers, ..Self::on::<O, I>(member) }
            }
            None => refuse(Text::new().text("no device takes both images")),
        }
    }

    /// The process data of both directions on one of the devices that have it.
    #[track_caller]
    pub const fn on<O, I>(device: &'static BringUp) -> Self
    where
        O: ProcessImage<Direction = Rx>,
        I: ProcessImage<Direction = Tx, Device = O::Device>,
    {
        if !device.takes::<O>() || !device.takes::<I>() {
            refuse(Text::new().text(device.name).text(" does not take these images"));
        }
        let outputs = if device.is_assignable::<Rx>() { Some(O::PDOS) } else { None };
        let inputs = if device.is_assignable::<Tx>() { Some(I::PDOS) } else { None };
        let devices = core::slice::from_ref(device);
        let BringUp { maps, axes, .. } = *device;
        Self { outputs, inputs, maps, axes, devices, takers: 1, mode: None, cycle: None }
    }

    /// With a mode of operation for each axis that has one.
    pub const fn mode(mut self, mode: i8) -> Self {
        self.mode = Some(mode);
        self
    }

    /// With a cycle time in nanoseconds, for each axis that has 0x60C2. That counts up to 255 of a power of ten of a second: a
    /// time that it cannot hold does not compile, nor does one that one of the devices does not take.
    #[track_caller]
    pub const fn cycle_ns<const NS: u64>(mut self) -> Self {
        let (mut devices, mut takers) = (self.devices, self.takers);
        while let Some((device, rest)) = devices.split_first() {
            if takers & 1 == 1 && !CycleLimit::any_takes(device.cycles, NS) {
                refuse(Text::new().text(device.name).text(" does not take this cycle time"));
            }
            (devices, takers) = (rest, takers >> 1);
        }
        self.cycle = Some(const { period(NS) });
        self
    }

    /// The number of writes.
    pub const fn len(&self) -> usize {
        self.list::<0>(true).length
    }

    /// Whether there is nothing to be written.
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The writes, in order; `N` is [`len`](Self::len).
    pub const fn writes<const N: usize>(&self) -> [Write; N] {
        self.list(true).writes
    }

    /// The number of values to read back.
    pub const fn verify_len(&self) -> usize {
        self.list::<0>(false).length
    }

    /// What is there once all is written, to be read back: the writes without those that later ones supersede; `N` is
    /// [`verify_len`](Self::verify_len).
    pub const fn verify<const N: usize>(&self) -> [Write; N] {
        self.list(false).writes
    }

    const fn list<const N: usize>(&self, clears: bool) -> List<N> {
        let assignments = [(Rx::ASSIGNMENT, self.outputs), (Tx::ASSIGNMENT, self.inputs)];
        let [(outputs, output_pdos), (inputs, input_pdos)] = assignments;
        let mut list = List::new(clears);
        if output_pdos.is_some() {
            list = list.clear(outputs, "clear the assignment of outputs");
        }
        if input_pdos.is_some() {
            list = list.clear(inputs, "clear the assignment of inputs");
        }
        if self.maps {
            list = list.mappings(input_pdos).mappings(output_pdos);
        }
        list = list.assignment(outputs, output_pdos).assignment(inputs, input_pdos);
        let mut axes = self.axes;
        while let Some((axis, rest)) = axes.split_first() {
            list = list.axis(axis, self.mode, self.cycle);
            axes = rest;
        }
        list
    }
}

/// The count and the power of ten in seconds: the largest unit in which the time is a whole number.
const fn period(ns: u64) -> (u8, i8) {
    let (mut count, mut exponent) = (ns, -9);
    while count != 0 && count.is_multiple_of(10) && (exponent < -3 || count > 255) {
        count /= 10;
        exponent += 1;
    }
    assert!(count != 0 && count <= 255, "the cycle time is not up to 255 of a power of ten of a second");
    (count as u8, exponent)
}
