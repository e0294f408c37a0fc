//! The ports of a device: a letter for each of up to four.

/// Whether a text says ports, as `PhysicsType` in the schema of ETG.2000 does.
pub(crate) fn are_ports(text: &str) -> bool {
    text.len() <= 4 && !text.trim().is_empty() && text.chars().all(|c| "YKH ".contains(c))
}
