//! What the memory of the slave controller is divided into, each sync manager in a row of its own.

use std::fmt::Write;

use super::begin;
use crate::emit::markdown::Area;

const LEFT: usize = 130;
const WIDTH: usize = 420;
const ROW: usize = 30;

/// The areas, each where it lies between the first and the last of them.
pub(super) fn svg(areas: &[Area]) -> String {
    let end = |area: &Area| usize::from(area.address) + usize::from(area.size) * usize::from(area.buffers);
    let first = areas.iter().map(|area| usize::from(area.address)).min().unwrap_or(0);
    let span = areas.iter().map(end).max().unwrap_or(0).saturating_sub(first).max(1);
    let height = areas.len() * ROW + 8;
    let mut out = begin(LEFT + WIDTH + 220, height, "bits", "The areas of the sync managers in memory");
    for (row, area) in areas.iter().enumerate() {
        let scaled = |bytes: usize| bytes * WIDTH / span;
        let y = row * ROW + 4;
        let text = y + 17;
        let _ = write!(
            out,
            "<text class=\"from\" x=\"2\" y=\"{text}\">SM{} {}</text>",
            area.number, area.carries
        );
        let width = scaled(area.size.into()).max(3);
        for buffer in 0..usize::from(area.buffers) {
            let x = LEFT + scaled(usize::from(area.address) - first) + buffer * width;
            let _ = write!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"24\"/>");
        }
        let x = LEFT + scaled(usize::from(area.address) - first) + width * usize::from(area.buffers) + 6;
        let _ =
            writeln!(out, "<text class=\"from\" x=\"{x}\" y=\"{text}\">{}</text>", bytes(area, end(area)));
    }
    out + "</svg>\n"
}

/// Where an area begins and ends, and how it is used.
fn bytes(area: &Area, end: usize) -> String {
    let last = end.saturating_sub(1);
    let buffers = if area.buffers > 1 { format!("{} × ", area.buffers) } else { String::new() };
    format!("0x{:04X}–0x{last:04X}, {buffers}{} bytes", area.address, area.size)
}
