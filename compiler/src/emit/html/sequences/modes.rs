//! How to start a mode of operation, and how to set the reference.

use super::Sequence;
use crate::model::{Device, Field, HomingBits, Index, Mappable, Mode};

const MODE: Index = Index(0x6060);
const MODE_DISPLAY: Index = Index(0x6061);
const METHOD: Index = Index(0x6098);

/// The command that the bits of a mode are added to.
const ENABLE: &str = "enable-operation";

/// How each mode is chosen and begun.
pub(super) fn start(device: &Device) -> Sequence {
    let modes = device.modes.iter().filter(|mode| mode.code != 0 && mode.homing_bits.is_none());
    Sequence {
        id: "into-a-mode",
        title: "Into a mode",
        about: "What chooses a mode, and what begins it once the drive is in operation.",
        head: "Mode",
        rows: modes.filter_map(|mode| Some((label(mode), steps(device, mode)?))).collect(),
    }
}

/// How the reference is set.
pub(super) fn home(device: &Device) -> Sequence {
    let modes = device.modes.iter();
    let runs = modes.filter_map(|mode| Some((label(mode), run(device, mode, mode.homing_bits.as_ref()?)?)));
    Sequence {
        id: "setting-the-reference",
        title: "Setting the reference",
        about: "A reference run, from the choice of the mode to the answer.",
        head: "Mode",
        rows: runs.collect(),
    }
}

fn label(mode: &Mode) -> String {
    format!("{} {}", mode.code, mode.name)
}

/// What chooses a mode; none if nothing that is described does.
fn choice(device: &Device, mode: &Mode) -> Option<Vec<String>> {
    let entry = device.object(MODE)?.entries.iter().find(|entry| entry.access.writable())?;
    let write = format!("write {} into {}", mode.code, entry.address.index);
    let display = device.object(MODE_DISPLAY);
    let wait = display.map(|object| format!("wait until {} is {}", object.index, mode.code));
    Some([write].into_iter().chain(wait).collect())
}

fn steps(device: &Device, mode: &Mode) -> Option<Vec<String>> {
    let mut steps = choice(device, mode)?;
    let values = mode.objects.iter().filter_map(|address| {
        let entry = device.entry(*address)?;
        let is_set =
            matches!(entry.pdo, Mappable::Rx | Mappable::RxTx) && !is_steering(device, address.index);
        is_set.then(|| format!("{} {}", address.index, name(device, address.index)))
    });
    let values = values.collect::<Vec<_>>().join(", ");
    if !values.is_empty() {
        let when = if mode.cyclic { "in every cycle" } else { "as it is needed" };
        steps.push(format!("set {when}: {values}"));
    }
    steps.extend(mode.control_bits.iter().filter_map(|field| begin(device, field)));
    Some(steps)
}

/// Whether an object chooses what the drive does, and not by how much.
fn is_steering(device: &Device, index: Index) -> bool {
    index == MODE || device.words.iter().any(|word| word.address.index == index)
}

fn name(device: &Device, index: Index) -> &str {
    device.object(index).map_or("", |object| object.name.as_str())
}

/// What a rising bit of the controlword begins.
fn begin(device: &Device, field: &Field) -> Option<String> {
    let effect = field.rising.as_ref().filter(|_| field.low == field.high)?;
    Some(format!("{} ({}): {effect}", rise(device, field.low), field.name))
}

/// How a bit of the controlword is made to rise: in words if the command that operation goes on with is one.
fn rise(device: &Device, bit: u8) -> String {
    let command = device.commands.iter().find(|command| command.id == ENABLE);
    let word = command.and_then(|command| command.pattern.as_ref()).map(crate::model::Pattern::value);
    match word.zip(1_u16.checked_shl(bit.into())) {
        Some((word, bit)) => format!("0x{:04X}, then 0x{:04X}", word & !bit, word | bit),
        None => format!("bit {bit} of the controlword rises"),
    }
}

fn run(device: &Device, mode: &Mode, bits: &HomingBits) -> Option<Vec<String>> {
    let mut steps = choice(device, mode)?;
    if let Some(object) = device.object(METHOD) {
        let numbers = device.homing_methods.iter().map(|method| method.number.to_string());
        let numbers = numbers.collect::<Vec<_>>().join(", ");
        let choice = if numbers.is_empty() { String::new() } else { format!(": {numbers}") };
        steps.push(format!("write the method into {}{choice}", object.index));
    }
    steps.push("bring the drive into operation".to_owned());
    steps.push(rise(device, bits.start));
    steps.push(format!(
        "wait for the statusword: bit {} says that the reference is set, bit {} that the run has failed, bit {} that it is over",
        bits.attained, bits.error, bits.reached
    ));
    Some(steps)
}
