//! What is wrong with a sync manager.

use std::fmt;

use devc_runtime::esm::{AlStatusCode, Area, Areas, Configured, Role};

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

/// Bits 0 to 3 of a control byte: mailboxes and buffers, to and from the device.
const fn control(role: Role) -> u8 {
    match role {
        Role::MailboxOut => 0x6,
        Role::MailboxIn => 0x2,
        Role::Outputs => 0x4,
        Role::Inputs => 0x0,
    }
}

/// What is wrong with the sync managers that a refusal is about.
pub(crate) fn faults(
    code: AlStatusCode,
    (areas, lengths): (Areas, Vec<usize>),
    managers: &[Configured],
) -> Vec<ManagerFault> {
    let mail = [Role::MailboxOut, Role::MailboxIn].into_iter();
    let numbered = |role: Role, areas: Vec<(usize, Area)>| {
        areas.into_iter().map(|(number, area)| (number, area, control(role))).collect::<Vec<_>>()
    };
    let judged: Vec<(usize, Area, u8)> = match code {
        AlStatusCode::INVALID_MAILBOX => {
            mail.flat_map(|role| numbered(role, areas.of(role).collect())).collect()
        }
        AlStatusCode::INVALID_BOOT_MAILBOX => {
            mail.flat_map(|role| numbered(role, areas.of_boot(role).collect())).collect()
        }
        AlStatusCode::INVALID_OUTPUTS => numbered(Role::Outputs, exact(areas, &lengths, Role::Outputs)),
        AlStatusCode::INVALID_INPUTS => numbered(Role::Inputs, exact(areas, &lengths, Role::Inputs)),
        _ => Vec::new(),
    };
    let faults = judged.into_iter().filter_map(|(manager, area, control)| {
        let found = managers.get(manager).copied().unwrap_or_default();
        Some(ManagerFault { manager, wrong: wrong(area, &found, control)? })
    });
    faults.collect()
}

/// Sync managers of process data are as long as what is mapped.
fn exact(areas: Areas, lengths: &[usize], role: Role) -> Vec<(usize, Area)> {
    let exact = areas.of(role).map(|(number, area)| {
        let length = u16::try_from(lengths.get(number).copied().unwrap_or(0)).unwrap_or(u16::MAX);
        (number, Area { length: (length, length), ..area })
    });
    exact.collect()
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
