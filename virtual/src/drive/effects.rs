//! What writing some entries sets off: triggers of the description, and the parameters that are stored.

use devc::model::{self, Device, Entry};
use devc_runtime::object::Address;
use devc_runtime::sdo::{AbortCode, Dictionary, Hooks};

use super::dictionary::{Number, Values};
use super::stored::Order;

/// The objects that show an error: the register, and the code on the first axis.
const ERROR_REGISTER: u16 = 0x1001;
const ERROR_CODE: u16 = 0x603F;
/// The mode of operation that an axis is in.
const MODE_DISPLAY: u16 = 0x6061;

/// An entry with a trigger, as the description has it.
#[derive(Debug, Clone)]
pub(super) struct Trigger {
    address: Address,
    /// What sets it off.
    value: Vec<u8>,
    /// The mode that has to be active.
    mode: Option<i64>,
    /// What it does, in words.
    pub(super) action: String,
    /// Whether it takes errors back.
    pub(super) clears_errors: bool,
}

/// The triggers of a device, and where its axes show their modes.
#[derive(Debug, Clone)]
pub(super) struct Triggers {
    all: Vec<Trigger>,
    modes: Vec<Number>,
}

impl Triggers {
    pub(super) fn new(device: &Device, table: &Dictionary) -> Self {
        let entries = device.objects.iter().flat_map(|object| &object.entries);
        let shown = match device.repetition(model::Index(MODE_DISPLAY)) {
            Some(repetition) => repetition.axes.iter().flatten().map(|index| index.0).collect(),
            None => vec![MODE_DISPLAY],
        };
        let modes = shown.into_iter().filter_map(|index| Number::find(table, Address::new(index, 0)));
        Self { all: entries.filter_map(trigger).collect(), modes: modes.collect() }
    }

    /// The trigger that a write sets off.
    fn find(&self, address: Address, data: &[u8]) -> Option<&Trigger> {
        self.all.iter().find(|trigger| trigger.address == address && trigger.value == data)
    }
}

fn trigger(entry: &Entry) -> Option<Trigger> {
    let trigger = entry.trigger.as_ref()?;
    let updates = |index: u16| trigger.updates.iter().any(|address| address.index.0 == index);
    Some(Trigger {
        address: Address::new(entry.address.index.0, entry.address.subindex),
        value: trigger.value.little_endian(entry.data_type),
        mode: trigger.mode.map(i64::from),
        action: trigger.action.clone(),
        clears_errors: updates(ERROR_REGISTER) || updates(ERROR_CODE),
    })
}

/// What was set off and is to be done.
#[derive(Debug, Clone, Copy)]
pub(super) enum Effect {
    Triggered(Address, &'static Trigger),
    Ordered(Order),
}

/// What stands behind the dictionary.
#[derive(Debug, Clone)]
pub(super) struct Effects {
    triggers: &'static Triggers,
    pub(super) waiting: Vec<Effect>,
}

impl Effects {
    pub(super) const fn new(triggers: &'static Triggers) -> Self {
        Self { triggers, waiting: Vec::new() }
    }
}

impl Hooks<Values> for Effects {
    fn before_download(&mut self, values: &mut Values, to: Address, data: &[u8]) -> Result<(), AbortCode> {
        match Order::of(to, data) {
            Some(Ok(order)) => self.waiting.push(Effect::Ordered(order)),
            Some(Err(())) => return Err(AbortCode::NOT_STORED),
            None => {}
        }
        let Some(trigger) = self.triggers.find(to, data) else { return Ok(()) };
        let is_in_mode = |mode| self.triggers.modes.iter().all(|shown| shown.get(values) == mode);
        if !trigger.mode.is_none_or(is_in_mode) {
            return Err(AbortCode::DEVICE_STATE);
        }
        self.waiting.push(Effect::Triggered(to, trigger));
        Ok(())
    }

    fn after_download(&mut self, values: &mut Values, address: Address) {
        // an order is no value: what is read there tells how the device stores
        if Order::is_at(address) {
            values.reset(address);
        }
    }
}
