//! The state machine as a picture: states below one another, and an arrow for each pair between which there are transitions, down
//! on the right and up on the left.

use minijinja::HtmlEscape;

use crate::emit::markdown::{Arrow, Label, Machine, Node};

const WIDTH: usize = 760;
const BOX: (usize, usize) = (210, 46);
const STEP: usize = 76;
/// How far apart arrows run that lie beside one another, and how far apart they meet a box.
const LANE: usize = 24;
const SLOT: usize = 10;

/// The picture, as SVG. States have the bits of the statusword that show them. Arrows have the numbers of their transitions,
/// which lead to what is said of these, and tell the command, its bits and its conditions where one points at them.
pub(in super::super) fn svg(machine: &Machine, title: &str) -> String {
    let row = |id: &str| machine.states.iter().position(|state| state.id == id);
    let mut sides = [Side::new(machine.states.len()), Side::new(machine.states.len())];
    let mut parts = Vec::new();
    for Arrow { from, to, labels } in &machine.arrows {
        if let (Some(start), Some(end)) = (row(from), row(to)) {
            let [up, down] = &mut sides;
            let side = if start < end { down } else { up };
            parts.push(arrow(side, start, end, labels));
        }
    }
    parts.extend(machine.states.iter().enumerate().map(|(row, one)| state(row, one)));
    let height = machine.states.len() * STEP + 10;
    // what many lanes take beyond the usual width, on either side
    let lanes = sides.iter().map(|side| side.lanes.len()).max().unwrap_or_default();
    let more = (offset(lanes) + LANE).saturating_sub(left());
    let (edge, width) = (if more > 0 { format!("-{more}") } else { "0".to_owned() }, WIDTH + 2 * more);
    format!(
        "<svg viewBox=\"{edge} 0 {width} {height}\" role=\"group\" class=\"machine\"><title>{}</title>\n\
         <defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">\
         <path d=\"M0 0 8 4 0 8z\"/></marker></defs>\n{}\n</svg>\n",
        HtmlEscape(title),
        parts.join("\n")
    )
}

/// The arrows on a side of the boxes.
struct Side {
    /// What each lane is taken by, from row to row.
    lanes: Vec<Vec<(usize, usize)>>,
    /// How many arrows meet each box.
    met: Vec<usize>,
}

impl Side {
    fn new(rows: usize) -> Self {
        Self { lanes: Vec::new(), met: vec![0; rows] }
    }

    /// The first lane that is free between two rows; it is taken.
    fn lane(&mut self, top: usize, bottom: usize) -> usize {
        let is_free =
            |taken: &Vec<(usize, usize)>| taken.iter().all(|(first, last)| *last < top || bottom < *first);
        let lane = self.lanes.iter().position(is_free).unwrap_or(self.lanes.len());
        match self.lanes.get_mut(lane) {
            Some(taken) => taken.push((top, bottom)),
            None => self.lanes.push(vec![(top, bottom)]),
        }
        lane
    }

    /// Where the next arrow meets a box.
    fn meet(&mut self, row: usize) -> usize {
        let met = self.met.get_mut(row).map_or(0, |met| std::mem::replace(met, *met + 1));
        row * STEP + 10 + SLOT / 2 + (met * SLOT) % (BOX.1 - SLOT)
    }
}

/// How far from the boxes a lane is.
fn offset(lane: usize) -> usize {
    56 + lane * LANE
}

fn left() -> usize {
    (WIDTH - BOX.0) / 2
}

fn state(row: usize, state: &Node) -> String {
    let (x, y) = (left(), row * STEP + 10);
    let name = HtmlEscape(&state.name);
    let text = |y: usize, class: &str, text: &str| {
        format!("<text{class} x=\"{}\" y=\"{y}\">{text}</text>", x + BOX.0 / 2)
    };
    let texts = match &state.bits {
        Some(bits) => {
            text(y + 19, "", &name.to_string())
                + &text(y + 36, " class=\"pattern\"", &HtmlEscape(bits).to_string())
        }
        None => text(y + BOX.1 / 2 + 5, "", &name.to_string()),
    };
    format!(
        "<g class=\"state\"><rect x=\"{x}\" y=\"{y}\" width=\"{}\" height=\"{}\" rx=\"6\"/>{texts}</g>",
        BOX.0, BOX.1
    )
}

fn arrow(side: &mut Side, start: usize, end: usize, labels: &[Label]) -> String {
    let offset = offset(side.lane(start.min(end), start.max(end)));
    let (y1, y2) = (side.meet(start), side.meet(end));
    let (edge, sign, text) =
        if start < end { (left() + BOX.0, "", left() + BOX.0 + 28) } else { (left(), "-", left() - 28) };
    let numbers = labels.iter().map(number).collect::<Vec<_>>().join(" ");
    let titles = labels.iter().map(title).collect::<Vec<_>>().join("\n");
    format!(
        "<g class=\"arrow\"><title>{}</title><path d=\"M{edge} {y1}h{sign}{offset}V{y2}H{edge}\" marker-end=\"url(#tip)\"/>\
         <text x=\"{text}\" y=\"{}\">{numbers}</text></g>",
        HtmlEscape(&titles),
        y1 + 4,
    )
}

/// The number of a transition, which leads to what is said of it.
fn number(label: &Label) -> String {
    format!(
        "<a href=\"#transition-{0}\" aria-label=\"Transition {1}\">{0}</a>",
        label.number,
        HtmlEscape(&title(label))
    )
}

/// The number, the command, its bits and its conditions.
fn title(label: &Label) -> String {
    let facts = if label.facts.is_empty() { String::new() } else { format!(": {}", label.facts.join("; ")) };
    format!("{label}{facts}")
}
