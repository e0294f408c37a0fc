//! The distributed clocks.

use super::node::{Node, attribute, flag, number, optional, optional_text, text};

/// A way to keep time.
#[derive(Debug)]
pub struct OpMode {
    /// Its name.
    pub name: String,
    /// What people call it.
    pub description: Option<String>,
    /// The register that starts the clocks.
    pub assign_activate: u16,
    /// The first signal.
    pub sync0: Option<Signal>,
    /// The second signal.
    pub sync1: Option<Signal>,
}

/// A signal of the clocks.
#[derive(Debug)]
pub struct Signal {
    /// Its period in cycles of the master.
    pub factor: Option<i32>,
    /// Its period in nanoseconds; 0 leaves it to the factor.
    pub period: u32,
    /// Its delay in nanoseconds.
    pub shift: i32,
    /// Its delay in cycles of the master.
    pub shift_factor: Option<i32>,
    /// Whether it is counted from the inputs.
    pub input: bool,
}

pub(super) fn op_mode(node: Node<'_, '_>) -> Result<OpMode, String> {
    Ok(OpMode {
        name: text(node, "Name")?,
        description: optional_text(node, "Desc")?,
        assign_activate: number(node, "AssignActivate")?,
        sync0: signal(node, "CycleTimeSync0", "ShiftTimeSync0")?,
        sync1: signal(node, "CycleTimeSync1", "ShiftTimeSync1")?,
    })
}

fn signal(node: Node<'_, '_>, cycle: &str, shift: &str) -> Result<Option<Signal>, String> {
    let Some(cycle) = optional(node, cycle)? else { return Ok(None) };
    let shift = optional(node, shift)?;
    Ok(Some(Signal {
        factor: attribute(cycle, "Factor")?,
        period: super::node::value(cycle)?,
        shift: shift.map(super::node::value).transpose()?.unwrap_or_default(),
        shift_factor: shift.map(|shift| attribute(shift, "Factor")).transpose()?.flatten(),
        input: shift.is_some_and(|shift| flag(shift, "Input")),
    }))
}
