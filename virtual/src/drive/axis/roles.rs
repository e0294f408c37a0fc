//! Which objects play which role on an axis (CiA 402; ETG.6010, index shift between axes).

use devc::model::{Address, Device, Entry, Index, Mode};
use devc_runtime::object;
use devc_runtime::sdo::Dictionary;

use crate::drive::dictionary::Number;

/// The objects of an axis, as far as the device has them.
#[derive(Debug)]
pub(super) struct Roles {
    pub(super) controlword: Option<Number>,
    pub(super) statusword: Option<Number>,
    pub(super) mode: Option<Number>,
    pub(super) mode_display: Option<Number>,
    pub(super) error_code: Option<Number>,
    pub(super) quick_stop_option: Option<Number>,
    pub(super) position: Vec<Number>,
    pub(super) velocity: Option<Number>,
    pub(super) vl_velocity: Option<Number>,
    pub(super) torque: Option<Number>,
    pub(super) following_error: Option<Number>,
    pub(super) target_velocity: Option<Number>,
    pub(super) vl_target_velocity: Option<Number>,
    pub(super) target_torque: Option<Number>,
    pub(super) torque_slope: Option<Number>,
    pub(super) profile_velocity: Option<Number>,
    pub(super) profile_acceleration: Option<Number>,
    pub(super) profile_deceleration: Option<Number>,
    pub(super) position_limits: Option<[Number; 2]>,
    pub(super) following_window: Option<Number>,
    pub(super) following_time: Option<Number>,
    pub(super) home_offset: Option<Number>,
    pub(super) homing_method: Option<Number>,
    pub(super) homing_speed: Option<Number>,
    pub(super) probe_function: Option<Number>,
    pub(super) probe_status: Option<Number>,
    /// Of the first and of the second touch probe, at the rising and the falling edge.
    pub(super) probe_positions: [[Option<Number>; 2]; 2],
    pub(super) probe_counts: [[Option<Number>; 2]; 2],
}

/// Finds the objects of an axis by their indices on the first.
pub(super) struct Finder<'a> {
    pub(super) device: &'a Device,
    pub(super) table: &'a Dictionary,
    pub(super) axis: u8,
}

impl Finder<'_> {
    /// The entry on this axis that is at an address on the first; of an object that is there once, that.
    pub(super) fn entry(&self, index: u16, subindex: u8) -> Option<&Entry> {
        let index = match self.device.repetition(Index(index)) {
            Some(repetition) => (*repetition.axes.get(usize::from(self.axis))?)?,
            None => Index(index),
        };
        self.device.entry(Address { index, subindex })
    }

    /// The same as a number that can change.
    pub(super) fn number(&self, index: u16, subindex: u8) -> Option<Number> {
        let Address { index, subindex } = self.entry(index, subindex)?.address;
        Number::find(self.table, object::Address::new(index.0, subindex))
    }

    /// The set-point of position that a mode uses: the one that its description names, or the usual one. Drives that
    /// interpolate take it in 0x60C1.
    pub(super) fn target_position(&self, mode: &Mode) -> Option<Number> {
        let candidates = match mode.code {
            7 => [(0x60C1, 1), (0x60C1, 0), (0x607A, 0)],
            _ => [(0x607A, 0), (0x60C1, 0), (0x60C1, 1)],
        };
        let is_named = |(index, _): &&(u16, u8)| mode.objects.iter().any(|object| object.index.0 == *index);
        let named = candidates.iter().filter(is_named);
        named.chain(&candidates).find_map(|(index, subindex)| self.number(*index, *subindex))
    }

    /// The objects that show the position in the unit of the set-points; 0x6063 counts steps of the encoder in some drives.
    fn position(&self) -> Vec<Number> {
        let unit = |index, subindex| self.entry(index, subindex)?.unit.as_ref();
        let set = unit(0x607A, 0).or_else(|| unit(0x60C1, 0)).or_else(|| unit(0x60C1, 1));
        let shown = || [0x6064, 0x6063].into_iter().filter_map(|index| Some((index, self.number(index, 0)?)));
        let same: Vec<Number> =
            shown().filter(|(index, _)| unit(*index, 0) == set).map(|(_, number)| number).collect();
        if same.is_empty() { shown().map(|(_, number)| number).take(1).collect() } else { same }
    }
}

impl Roles {
    pub(super) fn new(finder: &Finder<'_>) -> Self {
        let number = |index| finder.number(index, 0);
        let limits = [finder.number(0x607D, 1), finder.number(0x607D, 2)];
        Self {
            controlword: number(0x6040),
            statusword: number(0x6041),
            mode: number(0x6060),
            mode_display: number(0x6061),
            error_code: number(0x603F),
            quick_stop_option: number(0x605A),
            position: finder.position(),
            velocity: number(0x606C),
            vl_velocity: number(0x6044),
            torque: number(0x6077),
            following_error: number(0x60F4),
            target_velocity: number(0x60FF),
            vl_target_velocity: number(0x6042),
            target_torque: number(0x6071),
            torque_slope: number(0x6087),
            profile_velocity: number(0x6081),
            profile_acceleration: number(0x6083),
            profile_deceleration: number(0x6084),
            position_limits: limits[0].zip(limits[1]).map(<[Number; 2]>::from),
            following_window: number(0x6065),
            following_time: number(0x6066),
            home_offset: number(0x607C),
            homing_method: number(0x6098),
            homing_speed: finder.number(0x6099, 1),
            probe_function: number(0x60B8),
            probe_status: number(0x60B9),
            probe_positions: [[0x60BA, 0x60BB], [0x60BC, 0x60BD]].map(|edges| edges.map(number)),
            probe_counts: [[0x60D5, 0x60D6], [0x60D7, 0x60D8]].map(|edges| edges.map(number)),
        }
    }
}
