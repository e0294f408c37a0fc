//! Modules: what axes have in common, described once, with a slot for each axis (ETG.2000, ETG.5001).

use super::table::table;
use super::{Address, Axis, Device, Index, Object, Shift};

table! {
    /// `[modules.<ident>]`: what is in the slots of axes. With modules, the ESI has a slot for each axis, and what each
    /// axis has stands once, in the module; without, it has all objects of all axes in one dictionary.
    pub struct Module by ident: "a number of 32 bits such as 0x00000192" {
        /// The number that a master tells modules by, as 0xF030 and 0xF050 have it.
        #[serde(skip_deserializing)]
        pub ident: u32,
        /// Its name.
        pub name: String,
        /// The names of the axes that are such a module; all if absent.
        #[serde(default)]
        pub axes: Vec<String>,
    }
}

impl Module {
    /// Whether an axis is such a module.
    pub fn has(&self, axis: &Axis) -> bool {
        self.axes.is_empty() || self.axes.contains(&axis.name)
    }
}

/// The slots of a modular device.
#[derive(Debug, Clone, Copy)]
pub struct Slots<'d> {
    /// What is in them.
    pub axes: &'d [Axis],
    /// How far apart they are.
    pub shifts: &'d [Shift],
    /// The modules.
    pub modules: &'d [Module],
    /// The profile that each slot follows.
    pub profile: Option<u32>,
}

impl Slots<'_> {
    /// What an object tells a master of the slots (ETG.5001): 0xF000 how far apart they are and how many there can be,
    /// 0xF010 their profiles, 0xF050 the modules in them. None for all other objects.
    pub fn value(&self, address: Address) -> Option<u32> {
        let module = || {
            let axis = self.axes.get(usize::from(address.subindex.checked_sub(1)?))?;
            self.modules.iter().find(|module| module.has(axis))
        };
        match (address.index.0, address.subindex) {
            _ if self.modules.is_empty() => None,
            (0xF000, 1) => self.shifts.first().map(|shift| shift.by.into()),
            (0xF000, 2) => u32::try_from(self.axes.len()).ok(),
            (0xF010, _) => module().and(self.profile),
            (0xF050, _) => module().map(|module| module.ident),
            _ => None,
        }
    }
}

impl Device {
    /// The slots, if the device is modular.
    pub fn slots_of_axes(&self) -> Slots<'_> {
        Slots {
            axes: &self.axes,
            shifts: &self.arrangement.shifts,
            modules: &self.modules,
            profile: self.profile,
        }
    }

    /// The axes that are such a module.
    pub fn axes_of<'d>(&'d self, module: &'d Module) -> impl Iterator<Item = &'d Axis> {
        self.axes.iter().filter(|axis| module.has(axis))
    }

    /// The axis whose slot an object is in, if there are slots. Mapping objects are in none: they lie as far apart as PDOs
    /// and not as objects, so that only the device can say their indices.
    pub fn slot_of(&self, object: &Object) -> Option<u8> {
        object.axis.filter(|_| !self.modules.is_empty() && !object.index.is_derived())
    }

    /// The index on the first axis of what has this one on another, in its slot; none if it is in none, or in that of
    /// another axis. What the dictionary lacks is where objects of the axis would be.
    pub fn index_in_slot(&self, axis: u8, index: Index) -> Option<Index> {
        if let Some(object) = self.object(index) {
            return (self.slot_of(object) == Some(axis)).then_some(object.leading);
        }
        self.arrangement.shifts.iter().filter(|_| !self.modules.is_empty()).find_map(|shift| {
            let leading = Index(index.0.checked_sub(shift.by.checked_mul(axis.into())?)?);
            (shift.first..=shift.last).contains(&leading).then_some(leading)
        })
    }
}
