//! Bring-up: what a master writes through the mailbox before it goes to Safe-Operational, as constant data.
//!
//! Which writes there are, and in which order, says `devc-start-up`, as it does for the lists of a description. What the
//! device does not let a master write is not in a list.

mod bring_up;

use core::fmt;

use devc_start_up::{Choice, Interface, Period, Step};

use crate::Family;
use crate::object::Address;
use crate::pdo::{MappedPdo, ProcessImage, Rx, Tx, refuse};
use crate::text::Text;

pub use bring_up::BringUp;
pub use devc_start_up::{AxisObjects, CycleLimit};

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

    const fn all<const N: usize>(steps: [Step; N]) -> [Self; N] {
        let mut writes = [Self::new(Address::new(0, 0), &[], ""); N];
        let (mut places, mut steps): (&mut [Self], &[Step]) = (&mut writes, &steps);
        while let (Some((place, others)), Some((step, rest))) =
            (places.split_first_mut(), steps.split_first())
        {
            *place = Self::new(step.address, step.data(), step.task.text());
            (places, steps) = (others, rest);
        }
        writes
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
    outputs: &'static [MappedPdo],
    inputs: &'static [MappedPdo],
    /// The device that the list is made for.
    device: &'static BringUp,
    /// The devices that the choice may be for, and which of them take it, a bit each.
    devices: &'static [BringUp],
    takers: u64,
    mode: Option<i8>,
    cycle_ns: Option<u64>,
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
        let devices = core::slice::from_ref(device);
        let (outputs, inputs) = (O::PDOS, I::PDOS);
        Self { outputs, inputs, device, devices, takers: 1, mode: None, cycle_ns: None }
    }

    /// With a mode of operation for each axis that has one.
    #[track_caller]
    pub const fn mode(self, mode: i8) -> Self {
        Self { mode: Some(mode), ..self }.judged()
    }

    /// With a cycle time in nanoseconds, for each axis that has 0x60C2. That counts up to 255 of a power of ten of a second: a
    /// time that it cannot hold does not compile, nor does one that one of the devices does not take in this mode or, if none
    /// is chosen, with these PDOs.
    #[track_caller]
    pub const fn cycle_ns<const NS: u64>(self) -> Self {
        if Period::of_ns(NS).is_none() {
            refuse(Text::new().text("the cycle time is not up to 255 of a power of ten of a second"));
        }
        Self { cycle_ns: Some(NS), ..self }.judged()
    }

    /// The same, if each device takes the cycle time.
    #[track_caller]
    const fn judged(self) -> Self {
        let Some(ns) = self.cycle_ns else { return self };
        let interface = Interface { mode: self.mode, pdos: [self.outputs, self.inputs] };
        let (mut devices, mut takers) = (self.devices, self.takers);
        while let Some((device, rest)) = devices.split_first() {
            if takers & 1 == 1 && !interface.takes(device.cycles, ns) {
                refuse(Text::new().text(device.name).text(" does not take this cycle time"));
            }
            (devices, takers) = (rest, takers >> 1);
        }
        self
    }

    /// The number of writes.
    pub const fn len(&self) -> usize {
        self.choice().steps(&mut [])
    }

    /// Whether there is nothing to be written.
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The writes, in order; `N` is [`len`](Self::len).
    pub const fn writes<const N: usize>(&self) -> [Write; N] {
        let mut steps = [Step::NONE; N];
        self.choice().steps(&mut steps);
        Write::all(steps)
    }

    /// The number of values to read back.
    pub const fn verify_len(&self) -> usize {
        self.choice().lasting(&mut [])
    }

    /// What is there once all is written, to be read back: the writes without those that later ones supersede; `N` is
    /// [`verify_len`](Self::verify_len).
    pub const fn verify<const N: usize>(&self) -> [Write; N] {
        let mut steps = [Step::NONE; N];
        self.choice().lasting(&mut steps);
        Write::all(steps)
    }

    const fn choice(&self) -> Choice<'static> {
        let Self { outputs, inputs, device, mode, .. } = *self;
        let cycle = match self.cycle_ns {
            Some(ns) => Period::of_ns(ns),
            None => None,
        };
        let (outputs, inputs) = (device.way::<Rx>(outputs), device.way::<Tx>(inputs));
        Choice { outputs, inputs, axes: device.axes, mode, cycle }
    }
}
