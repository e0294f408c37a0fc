//! What the profile of a device says of it and of its channels, which are the axes of a drive.

use super::super::read::{Channel, Device};
use super::super::report::Report;
use super::super::toml::{Toml, get};
use super::axes::Axes;
use super::described::Described;

/// Reports what follows neither from the device type, object 0x1000, nor from the axes. Gives back what each axis is, if
/// the axes have to say it.
pub(super) fn channels(
    device: &Device,
    objects: &[Described],
    axes: &Axes,
    report: &mut Report,
) -> Option<u16> {
    let names = axes.names();
    let of_type = device_type(device, objects);
    if let Some((info, at)) = device.add_info.filter(|(info, _)| !follows(*info, of_type)) {
        report.lose(at, 1, "Profile/AddInfo", format!("{info} is not what object 0x1000 says"));
    }
    let of_axes = same(&device.channels, names.len()).filter(|info| !follows((*info).into(), of_type));
    for (place, channel) in device.channels.iter().enumerate() {
        let other = channel.name.as_ref().filter(|name| names.get(place) != Some(*name));
        if let Some(name) = other {
            report.lose(channel.at, 1, "ChannelInfo/DisplayName", format!("`{name}` is no name of an axis"));
        }
        let is_said = |info: &u32| follows(*info, of_type) || of_axes.map(u32::from) == Some(*info);
        if let Some(info) = channel.add_info.filter(|info| !is_said(info)) {
            let why = format!("{info} is neither what object 0x1000 says nor the same for all axes");
            report.lose(channel.at, 1, "ChannelInfo/AddInfo", why);
        }
    }
    if let Some((count, at)) = device.channel_count.filter(|(count, _)| *count != names.len().max(1)) {
        let why = format!("channels are axes, of which there are {}; it says {count}", names.len().max(1));
        report.lose(at, 1, "Profile/ChannelCount", why);
    }
    of_axes
}

/// The upper word of the device type, if the lower one is the profile.
fn device_type(device: &Device, objects: &[Described]) -> Option<u32> {
    let object = objects.iter().find(|object| object.index == 0x1000)?;
    let value = match get(&object.values.first()?.keys, "default")? {
        Toml::Hex(value, _) => u32::try_from(*value).ok()?,
        Toml::Integer(value) => u32::try_from(*value).ok()?,
        _ => return None,
    };
    (Some(value & 0xFFFF) == device.profile).then_some(value >> 16)
}

/// 0 says nothing.
fn follows(info: u32, of_type: Option<u32>) -> bool {
    info == 0 || of_type == Some(info)
}

/// What the channels of several axes are, if all are the same.
fn same(channels: &[Channel], axes: usize) -> Option<u16> {
    let first = channels.first().filter(|_| axes > 1 && channels.len() == axes)?;
    let is_same = channels.iter().all(|it| it.add_info == first.add_info);
    first.add_info.filter(|_| is_same).and_then(|info| u16::try_from(info).ok())
}
