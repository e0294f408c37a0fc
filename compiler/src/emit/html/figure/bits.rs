//! Bits of words and of process data, as boxes.

use std::fmt::Write;

use minijinja::HtmlEscape;

use super::{begin, fitting};
use crate::emit::markdown::Part;

/// How high a box is.
const BOX: usize = 30;

/// A word: a box for each bit, the highest on the left, and names that lead to them. More than 16 bits take several rows.
pub(super) fn word(count: u32, parts: &[Part]) -> String {
    const BIT: usize = 38;
    const NAMES: usize = 98;
    const LEFT: usize = 120;
    const ROW: u32 = 16;
    let rows = count.div_ceil(ROW);
    let height = size(rows) * (BOX + NAMES + 24);
    let mut out = begin(LEFT + size(count.min(ROW)) * BIT + 10, height, "bits", "The bits of the word");
    for row in 0..rows {
        let (low, high) = (row * ROW, (row * ROW + ROW).min(count));
        let top = size(rows - 1 - row) * (BOX + NAMES + 24) + 16;
        let left = |bit: u32| LEFT + size(high - 1 - bit) * BIT;
        for bit in low..high {
            let x = left(bit) + BIT / 2;
            let _ = write!(out, "<text class=\"at\" x=\"{x}\" y=\"{}\">{bit}</text>", top - 4);
        }
        for part in parts {
            let Some((first, bits)) = within(part, low, high) else { continue };
            let (x, width) = (left(first + bits - 1), size(bits) * BIT);
            shape(&mut out, part, [x, top, width, BOX]);
            if !part.is_reserved {
                let (x, y) = (x + width / 2 + 4, top + BOX + 12);
                let name = fitting(&part.name, 140);
                let _ = write!(
                    out,
                    "<text class=\"lean\" transform=\"translate({x} {y}) rotate(-38)\">{name}</text>"
                );
            }
        }
        out.push('\n');
    }
    out + "</svg>\n"
}

/// The bytes of a PDO as they travel, eight in a row; in a byte the lowest bit is on the left.
pub(super) fn bytes(count: u32, parts: &[Part]) -> String {
    const BIT: usize = 11;
    const ROW: u32 = 64;
    let rows = count.div_ceil(ROW);
    let width = size(count.min(ROW).next_multiple_of(8)) * BIT + 4;
    let mut out = begin(width, size(rows) * (BOX + 20), "bits", "The bytes of the PDO");
    for row in 0..rows {
        let (low, high) = (row * ROW, (row * ROW + ROW).min(count));
        let top = size(row) * (BOX + 20) + 16;
        for byte in low / 8..high.div_ceil(8) {
            let x = 2 + size(byte * 8 - low) * BIT + 4 * BIT;
            let _ = write!(out, "<text class=\"at\" x=\"{x}\" y=\"{}\">{byte}</text>", top - 4);
        }
        for part in parts {
            let Some((first, bits)) = within(part, low, high) else { continue };
            let (x, width) = (2 + size(first - low) * BIT, size(bits) * BIT);
            shape(&mut out, part, [x, top, width, BOX]);
            let (x, y) = (x + width / 2, top + BOX / 2 + 4);
            let name = if part.is_reserved { String::new() } else { fitting(&part.name, width - 4) };
            let _ = write!(out, "<text x=\"{x}\" y=\"{y}\">{name}</text>");
        }
        out.push('\n');
    }
    out + "</svg>\n"
}

/// The bits of a part between two others: the first, and how many.
fn within(part: &Part, low: u32, high: u32) -> Option<(u32, u32)> {
    let first = part.first.max(low);
    let end = part.first.saturating_add(part.bits).min(high);
    (first < end).then(|| (first, end - first))
}

fn shape(out: &mut String, part: &Part, [x, y, width, height]: [usize; 4]) {
    let class = if part.is_reserved { " class=\"reserved\"" } else { "" };
    let _ = write!(
        out,
        "<rect{class} x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"><title>{}</title></rect>",
        HtmlEscape(&part.name)
    );
}

fn size(count: u32) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(first: u32, bits: u32, name: &str) -> Part {
        Part { first, bits, name: name.to_owned(), is_reserved: false }
    }

    #[test]
    fn a_field_that_reaches_into_the_next_row_has_a_box_in_both() {
        let drawn = bytes(80, &[part(0, 48, "first"), part(48, 32, "<second>")]);
        assert_eq!(drawn.matches("<rect").count(), 3);
        assert_eq!(drawn.matches("<title>&lt;second&gt;</title>").count(), 2);
    }

    #[test]
    fn the_highest_bit_of_a_word_is_on_the_left() {
        let drawn = word(16, &[part(0, 1, "low"), part(15, 1, "high")]);
        let place = |name: &str| {
            let (before, _) = drawn.split_once(&format!("<title>{name}</title>")).unwrap();
            let (_, x) = before.rsplit_once(" x=\"").unwrap();
            x.split('"').next().unwrap().parse::<usize>().unwrap()
        };
        assert_eq!(place("low") - place("high"), 15 * 38);
    }
}
