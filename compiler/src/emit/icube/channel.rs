//! Channels of process data, and writes at start-up.

use std::f64::consts::PI;

use serde::Serialize;

use crate::emit::program::{Entry, Kind, Setup, Step};
use crate::model::Dimension;

/// A PDO.
#[derive(Debug, Serialize)]
pub(super) struct Pdo<'s> {
    index: u16,
    title: &'s str,
    channels: Vec<Channel>,
}

/// A channel.
#[derive(Debug, Serialize)]
struct Channel {
    index: u16,
    subindex: u8,
    kind: String,
    /// `command_interface` or `state_interface`, where a controller can reach it.
    interface: Option<&'static str>,
    name: String,
    default: Option<String>,
    factor: Option<f64>,
}

/// A write.
#[derive(Debug, Serialize)]
pub(super) struct Write<'s> {
    index: u16,
    subindex: u8,
    kind: String,
    value: i32,
    title: &'s str,
}

/// The PDOs of a direction.
pub(super) fn channels(setup: &Setup, is_output: bool, has_axes: bool) -> Vec<Pdo<'_>> {
    let managers = setup.managers.iter().filter(|it| it.is_process_data && it.is_output == is_output);
    let pdos = managers.flat_map(|manager| &manager.pdos).map(|pdo| Pdo {
        index: pdo.index,
        title: &pdo.title,
        channels: pdo.entries.iter().map(|entry| channel(entry, is_output, has_axes)).collect(),
    });
    pdos.collect()
}

/// What is written at start-up; values are numbers with a sign there, whatever their type.
pub(super) fn writes(setup: &Setup) -> Vec<Write<'_>> {
    let held = setup.sdos.iter().filter_map(|sdo| {
        let value = match *sdo.data.as_slice() {
            [byte] => i32::from(byte.cast_signed()),
            [low, high] => i32::from(i16::from_le_bytes([low, high])),
            [a, b, c, d] => i32::from_le_bytes([a, b, c, d]),
            _ => return None,
        };
        let kind = format!("int{}", sdo.bits);
        Some(Write { index: sdo.index, subindex: sdo.subindex, kind, value, title: &sdo.title })
    });
    held.collect()
}

fn channel(entry: &Entry, is_output: bool, has_axes: bool) -> Channel {
    let Entry { index, subindex, bits, value } = entry;
    let kind = value.as_ref().and_then(|value| kind(value.kind, *bits));
    let is_held = kind.is_some();
    let mut channel = Channel {
        index: *index,
        subindex: *subindex,
        kind: kind.unwrap_or_else(|| format!("bit{bits}")),
        interface: None,
        name: String::new(),
        default: None,
        factor: None,
    };
    let Some(value) = value.as_ref().filter(|_| is_held) else { return channel };
    let role = role(value.leading.index.0).filter(|_| !has_axes && value.leading.subindex == 0);
    let name = match role {
        // the plug-in takes it by its index
        Some("") => return channel,
        Some(role) => role.to_owned(),
        None => value.name.clone(),
    };
    if role == Some("position") && is_output {
        // until the plug-in has taken the actual position
        channel.default = Some(".nan".to_owned());
    }
    channel.interface = Some(if is_output { "command_interface" } else { "state_interface" });
    channel.name = name;
    channel.factor = value.step.and_then(si).map(|si| if is_output { 1.0 / si } else { si });
    channel
}

/// The type of a channel, if there is one.
fn kind(kind: Kind, bits: u32) -> Option<String> {
    match (kind, bits) {
        (Kind::Bool, 1) => Some("bool".to_owned()),
        (Kind::Int, 8 | 16 | 32 | 64) => Some(format!("int{bits}")),
        (Kind::Bool | Kind::Uint, 8 | 16 | 32 | 64) => Some(format!("uint{bits}")),
        _ => None,
    }
}

/// What a value of CiA 402 is to controllers of ROS 2; nothing for what the plug-in takes for itself.
fn role(leading: u16) -> Option<&'static str> {
    Some(match leading {
        0x6040 | 0x6041 | 0x6060 | 0x6061 => "",
        0x607A | 0x6064 => "position",
        0x60FF | 0x606C => "velocity",
        0x6071 | 0x6077 => "effort",
        _ => return None,
    })
}

/// Metres, radians, these in a second, and newton metres for one raw step.
fn si(step: Step) -> Option<f64> {
    let per_smallest = match step.dimension {
        Dimension::Length | Dimension::Velocity | Dimension::Torque | Dimension::Force => 1e-9,
        Dimension::Angle | Dimension::AngularVelocity => 1e-9 * PI / 180.0,
        _ => return None,
    };
    let (units, raw) = step.smallest;
    Some(units * per_smallest / raw)
}
