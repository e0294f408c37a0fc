//! What is wrong with a sync manager.

use std::fmt;

use devc_runtime::esm::{AlStatusCode, Area, Areas, Configured, Lengths};

/// A sync manager that is not set as the device needs it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ManagerFault {
    /// Its number.
    pub manager: usize,
    /// What is wrong.
    pub wrong: Wrong,
}

/// What is wrong with a sync manager.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrong {
    /// It is off.
    Off,
    /// It is on, but nothing is mapped to it.
    On,
    /// It begins elsewhere.
    Address {
        /// Where it has to begin.
        expected: u16,
        /// Where it begins.
        found: u16,
    },
    /// It has another length.
    Length {
        /// The least and the greatest.
        expected: (u16, u16),
        /// The length that it has.
        found: u16,
    },
    /// Its control byte has another direction, or another kind of buffers.
    Control {
        /// Bits 0 to 3 as they have to be.
        expected: u8,
        /// The control byte.
        found: u8,
    },
}

impl fmt::Display for ManagerFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "sync manager {} ", self.manager)?;
        match self.wrong {
            Wrong::Off => f.write_str("is off"),
            Wrong::On => f.write_str("is on, but nothing is mapped to it"),
            Wrong::Address { expected, found } => {
                write!(f, "begins at 0x{found:04X} instead of 0x{expected:04X}")
            }
            Wrong::Length { expected: (least, greatest), found } if least == greatest => {
                write!(f, "has {found} bytes instead of {least}")
            }
            Wrong::Length { expected: (least, greatest), found } => {
                write!(f, "has {found} bytes, it takes {least} to {greatest}")
            }
            Wrong::Control { expected, found } => {
                write!(f, "has control byte 0x{found:02X}, of which bits 0 to 3 have to be 0x{expected:X}")
            }
        }
    }
}

/// Bits 0 to 3 of control bytes: mailboxes and buffers, to and from the device.
const MAIL_OUT: u8 = 0x6;
const MAIL_IN: u8 = 0x2;
const OUTPUTS: u8 = 0x4;
const INPUTS: u8 = 0x0;

/// What is wrong with the sync managers that a refusal is about.
pub(crate) fn faults(
    code: AlStatusCode,
    (areas, lengths): (Areas, Lengths),
    managers: &[Configured; 4],
    numbers: [usize; 4],
) -> Vec<ManagerFault> {
    let [mail_out, mail_in, outputs, inputs] = managers;
    let exact = |area: Option<Area>, length: usize| {
        let length = u16::try_from(length).unwrap_or(u16::MAX);
        area.map(|area| Area { length: (length, length), ..area })
    };
    let judged = match code {
        AlStatusCode::INVALID_MAILBOX => {
            vec![(0, areas.mailbox_out, mail_out, MAIL_OUT), (1, areas.mailbox_in, mail_in, MAIL_IN)]
        }
        AlStatusCode::INVALID_BOOT_MAILBOX => {
            vec![(0, areas.boot_out, mail_out, MAIL_OUT), (1, areas.boot_in, mail_in, MAIL_IN)]
        }
        AlStatusCode::INVALID_OUTPUTS => {
            vec![(2, exact(areas.outputs, lengths.outputs), outputs, OUTPUTS)]
        }
        AlStatusCode::INVALID_INPUTS => vec![(3, exact(areas.inputs, lengths.inputs), inputs, INPUTS)],
        _ => Vec::new(),
    };
    let faults = judged.into_iter().filter_map(|(manager, area, found, control)| {
        let manager = numbers.get(manager).copied()?;
        Some(ManagerFault { manager, wrong: wrong(area?, found, control)? })
    });
    faults.collect()
}

fn wrong(area: Area, found: &Configured, control: u8) -> Option<Wrong> {
    if area.length == (0, 0) {
        return found.is_on.then_some(Wrong::On);
    }
    if !found.is_on {
        return Some(Wrong::Off);
    }
    if found.address != area.address {
        return Some(Wrong::Address { expected: area.address, found: found.address });
    }
    if !(area.length.0..=area.length.1).contains(&found.length) {
        return Some(Wrong::Length { expected: area.length, found: found.length });
    }
    let is_right = found.control & 0x0F == control;
    (!is_right).then_some(Wrong::Control { expected: control, found: found.control })
}
