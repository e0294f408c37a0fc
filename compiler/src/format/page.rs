//! A file: its tables with all that stands between their lines.

use super::lead::Lead;
use super::line::{self, Line};
use super::order;
use super::value::Printer;
use crate::reference::Shape;
use crate::written::{Headed, Written, names};

/// A file as it is to be laid out.
pub(super) struct Page<'t> {
    text: &'t str,
    written: Written,
}

/// A table with what stands above its header, behind it and between its lines.
struct Block<'t, 'w> {
    table: &'w Headed,
    lead: Lead<'t>,
    trail: String,
    lines: Vec<Line<'t, 'w>>,
}

impl<'t> Page<'t> {
    pub(super) fn of(text: &'t str) -> Self {
        Self { text, written: Written::read(text) }
    }

    pub(super) fn print(&self) -> String {
        let (mut blocks, end) = self.blocks();
        let mut out = String::new();
        if are_free(&mut blocks, &end, &mut out) {
            self.sort(&mut blocks);
        }
        let mut before: Option<&Headed> = None;
        for block in blocks {
            let table = block.table;
            self.block(block, before, &mut out);
            before = Some(table);
        }
        end.print(&mut out);
        out
    }

    /// The tables, and what stands behind the last of their lines.
    fn blocks(&self) -> (Vec<Block<'t, '_>>, Lead<'t>) {
        let mut blocks: Vec<Block<'t, '_>> = Vec::new();
        let mut last = 0;
        for table in &self.written.tables {
            let mut lead = Lead::default();
            if !table.header.is_empty() {
                let (trail, above) = self.gap(last, table.header.start);
                keep(&mut blocks, trail);
                lead = Lead::of(above);
                last = table.header.end;
            }
            blocks.push(Block { table, lead, trail: String::new(), lines: Vec::new() });
            for item in &table.items {
                let (trail, above) = self.gap(last, item.at().start);
                keep(&mut blocks, trail);
                last = item.at().end;
                if let Some(block) = blocks.last_mut() {
                    block.lines.push(Line { lead: Lead::of(above), item, trail: String::new() });
                }
            }
        }
        let (trail, end) = self.gap(last, self.text.len());
        keep(&mut blocks, trail);
        (blocks, Lead::to_end(end))
    }

    /// What stands between two places: in the line of the first, and above the line of the second.
    fn gap(&self, from: usize, to: usize) -> (&'t str, &'t str) {
        let gap = self.text.get(from..to).unwrap_or_default();
        if from == 0 { ("", gap) } else { gap.split_once('\n').unwrap_or((gap, "")) }
    }

    /// Puts the tables in the order of the format.
    fn sort(&self, blocks: &mut [Block<'t, '_>]) {
        let mut members: Vec<&str> = Vec::new();
        for table in &self.written.tables {
            let mut path = names(&table.path);
            if let (Some("members"), Some(member)) = (path.next(), path.next())
                && !members.contains(&member)
            {
                members.push(member);
            }
        }
        let sections = order::keys(Some(Shape::file()));
        blocks.sort_by_key(|block| order::place(block.table, &sections, &members));
    }

    fn block(&self, mut block: Block<'t, '_>, before: Option<&Headed>, out: &mut String) {
        let path = names(&block.table.path).map(str::to_owned).collect();
        let inside = Printer { text: self.text, path, depth: 0 };
        if !block.table.header.is_empty() {
            above(&block, before, out).print(out);
            let (open, close) = if block.table.is_element { ("[[", "]]") } else { ("[", "]") };
            let key = Printer { path: Vec::new(), ..inside.clone() }.key(&block.table.path);
            out.push_str(&format!("{open}{key}{close}{}\n", block.trail));
        }
        if let Some(first) = block.lines.first_mut().filter(|line| out.is_empty() || line.lead.is_blank()) {
            first.lead = first.lead.tight();
        }
        line::print(block.lines, &inside, out);
    }
}

/// Keeps a comment with the line that it stands in.
fn keep(blocks: &mut [Block<'_, '_>], trail: &str) {
    let Some(block) = blocks.last_mut() else { return };
    let of = block.lines.last_mut().map_or(&mut block.trail, |line| &mut line.trail);
    let trail = trail.trim_end();
    *of = match trail.starts_with('#') {
        true => format!(" {trail}"),
        false => trail.to_owned(),
    };
}

/// What is to be printed above a header: a blank line before what is about another thing.
fn above<'t>(block: &Block<'t, '_>, before: Option<&Headed>, out: &str) -> Lead<'t> {
    if out.is_empty() {
        return block.lead.tight();
    }
    let thing = |table: &Headed| names(order::thing(table)).map(str::to_owned).collect::<Vec<_>>();
    let is_next = block.table.is_element && block.table.path.len() == 1;
    let is_same = before.is_some_and(|before| thing(before) == thing(block.table)) && !is_next;
    match is_same {
        true if block.lead.is_blank() => block.lead.tight(),
        true => block.lead.clone(),
        false => block.lead.loose(),
    }
}

/// Whether tables can change places: no comment stands between them that is about more than the table below it. What
/// stands at the top of the file stays there, and is printed.
fn are_free<'t>(blocks: &mut [Block<'t, '_>], end: &Lead<'t>, out: &mut String) -> bool {
    let is_headless = blocks.first().is_some_and(|root| root.lines.is_empty());
    if let Some(first) = blocks.get_mut(1).filter(|first| is_headless && first.lead.has_heading()) {
        first.lead.behead().print(out);
    }
    end.is_blank() && !blocks.iter().any(|block| block.lead.has_heading())
}
