//! Names of axes that stand in brackets behind the names of what belongs to them, as in devc's own outputs.

use super::super::read::Device;

/// The control words of axes, one behind the other.
const CONTROLWORD: u16 = 0x6040;

/// How far apart the objects of axes are, ETG.6010.
const STEP: u16 = 0x800;

/// Takes the names of the axes out of all other names, if all control words have one; then the axes are called by them.
/// Else they are called as channels are.
pub(in super::super) fn take_out(device: &mut Device) {
    let channels = device.channels.iter().map(|channel| channel.name.clone());
    if device.slots.is_empty() {
        device.slots = channels.collect::<Option<_>>().unwrap_or_default();
    }
    let mut axes: Vec<String> = Vec::new();
    for axis in 0..8_u16 {
        let index = CONTROLWORD + axis * STEP;
        let Some(object) = device.objects.iter().find(|object| object.index == index) else { break };
        let Some((_, axis)) = object.name.as_deref().and_then(bracketed) else { return };
        axes.push(axis.to_owned());
    }
    let is_new = |(place, axis): (usize, &String)| !axes.iter().take(place).any(|other| other == axis);
    if axes.len() < 2 || !axes.iter().enumerate().all(is_new) {
        return;
    }
    let of_axis = |index: u16| axes.get(usize::from(index.checked_sub(0x6000)? / STEP)).map(String::as_str);
    for object in &mut device.objects {
        strip(&mut object.name, of_axis(object.index));
    }
    for pdo in device.rx_pdos.iter_mut().chain(&mut device.tx_pdos) {
        let axis = pdo.name.as_deref().and_then(bracketed).map(|(_, axis)| axis.to_owned());
        strip(&mut pdo.name, axis.as_deref().filter(|axis| axes.iter().any(|known| known == axis)));
        for entry in &mut pdo.entries {
            strip(&mut entry.name, of_axis(entry.index));
        }
    }
    device.slots = axes;
}

/// `Controlword (X)` is the name of something and of its axis.
fn bracketed(name: &str) -> Option<(&str, &str)> {
    name.strip_suffix(')')?.rsplit_once(" (")
}

fn strip(name: &mut Option<String>, axis: Option<&str>) {
    let bare = name.as_deref().and_then(bracketed).filter(|(_, own)| Some(*own) == axis);
    if let Some(bare) = bare.map(|(bare, _)| bare.to_owned()) {
        *name = Some(bare);
    }
}
