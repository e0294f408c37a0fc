//! Values: numbers, lists and tables in braces.

use std::ops::Range;

use super::{number, order};
use crate::reference::Shape;
use crate::reference::relation::{Names, names as names_of, within_device};
use crate::written::{Item, Key, Kind, Value, names};

/// Prints what stands in a table or under a key of a text.
#[derive(Clone)]
pub(super) struct Printer<'t> {
    pub(super) text: &'t str,
    /// The keys of what is printed, from the top of the file.
    pub(super) path: Vec<String>,
    /// How many brackets with lines of their own are around it.
    pub(super) depth: usize,
}

/// A list or a table in braces: its brackets, and the space beside them in a line.
const LIST: (&str, &str, &str) = ("[", "]", "");
const TABLE: (&str, &str, &str) = ("{", "}", " ");

impl<'t> Printer<'t> {
    pub(super) fn written(&self, at: &Range<usize>) -> &'t str {
        self.text.get(at.clone()).unwrap_or_default()
    }

    /// What the format knows of it.
    pub(super) fn shape(&self) -> Option<Shape> {
        Shape::find(self.path.iter().map(String::as_str))
    }

    /// For what stands under a key of this table.
    fn under(&self, path: &[Key]) -> Self {
        let path = self.path.iter().cloned().chain(names(path).map(str::to_owned)).collect();
        Self { path, ..*self }
    }

    /// A key of one part or several, with dots.
    pub(super) fn key(&self, path: &[Key]) -> String {
        let mut around: Vec<&str> = self.path.iter().map(String::as_str).collect();
        let mut parts = Vec::new();
        for key in path {
            let name = number::key(&key.name, order::has_indices(&around));
            parts.push(number::quoted(&name, self.written(&key.at)));
            around.push(&key.name);
        }
        parts.join(".")
    }

    /// What a key of this table is set to.
    pub(super) fn of(&self, item: &Item) -> String {
        let name = item.path.last().map_or("", |key| key.name.as_str());
        item.value.as_ref().map(|value| self.under(&item.path).value(value, name)).unwrap_or_default()
    }

    fn value(&self, value: &Value, name: &str) -> String {
        match &value.kind {
            Kind::Text(text) => self.text(text, self.written(&value.at)),
            Kind::Other if matches!(name, "vendor-id" | "product-code") => {
                number::code(self.written(&value.at))
            }
            Kind::Other => number::value(self.written(&value.at)),
            Kind::List(values) => {
                let parts: Vec<Range<usize>> = values.iter().map(|value| value.at.clone()).collect();
                let inner = self.inside(&value.at, &parts);
                let print = |part: &Value| (part.at.clone(), inner.value(part, ""));
                self.sequence(&value.at, values.iter().map(print).collect(), LIST)
            }
            Kind::Table(items) => self.table(&value.at, items),
        }
    }

    /// A text as it is written, but for an index that names something.
    fn text(&self, text: &str, written: &str) -> String {
        let Some(index) = number::reference(text).filter(|index| index != text) else {
            return written.to_owned();
        };
        let path: Vec<&str> = self.path.iter().map(String::as_str).collect();
        let is_name = matches!(
            names_of(within_device(&path)),
            Some(Names::Objects | Names::Things(_) | Names::Siblings | Names::Places)
        );
        if is_name { written.replacen(text, &index, 1) } else { written.to_owned() }
    }

    fn table(&self, at: &Range<usize>, items: &[Item]) -> String {
        let parts: Vec<Range<usize>> = items.iter().map(Item::at).collect();
        let inner = self.inside(at, &parts);
        let print = |item: &Item| (item.at(), inner.item(item));
        // what has lines of its own may have comments, which belong where they are
        if self.has_lines(at, &parts) {
            return self.sequence(at, items.iter().map(print).collect(), TABLE);
        }
        let mut sorted: Vec<&Item> = items.iter().collect();
        let keys = order::keys(self.shape());
        sorted.sort_by_key(|item| order::rank(&keys, &item.path));
        let printed: Vec<String> = sorted.into_iter().map(|item| inner.item(item)).collect();
        if printed.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", printed.join(", ")) }
    }

    /// A key with its value in a line.
    fn item(&self, item: &Item) -> String {
        format!("{} = {}", self.key(&item.path), self.of(item))
    }

    fn inside(&self, at: &Range<usize>, parts: &[Range<usize>]) -> Self {
        let depth = self.depth + usize::from(self.has_lines(at, parts));
        Self { depth, path: self.path.clone(), ..*self }
    }

    /// Whether there is a line break between the parts.
    fn has_lines(&self, at: &Range<usize>, parts: &[Range<usize>]) -> bool {
        self.gaps(at, parts).iter().any(|gap| gap.contains('\n'))
    }

    /// What stands before each of the parts, and behind the last one.
    fn gaps(&self, at: &Range<usize>, parts: &[Range<usize>]) -> Vec<&'t str> {
        let ends = parts.iter().map(|part| part.end);
        let starts = parts.iter().map(|part| part.start);
        let starts = starts.chain([at.end.saturating_sub(1)]);
        [at.start + 1]
            .into_iter()
            .chain(ends)
            .zip(starts)
            .map(|(end, start)| self.written(&(end..start)))
            .collect()
    }

    /// The parts in brackets, with the line breaks and comments that there are.
    fn sequence(
        &self,
        at: &Range<usize>,
        parts: Vec<(Range<usize>, String)>,
        (open, close, space): (&str, &str, &str),
    ) -> String {
        let places: Vec<Range<usize>> = parts.iter().map(|(at, _)| at.clone()).collect();
        let gaps = self.gaps(at, &places);
        let count = parts.len();
        let mut texts = parts.into_iter().map(|(_, text)| text);
        let mut out = open.to_owned();
        for (place, gap) in gaps.iter().enumerate() {
            let is_last = place == count;
            let has_lines = gap.contains('\n');
            if place > 0 && (!is_last || has_lines) {
                out.push(',');
            }
            if has_lines {
                self.lines(gap, is_last, &mut out);
            } else if place > 0 && !is_last {
                out.push(' ');
            } else if count > 0 {
                out.push_str(space);
            }
            out.push_str(&texts.next().unwrap_or_default());
        }
        out.push_str(close);
        out
    }

    /// The line breaks and comments of a gap, up to where the next part begins.
    fn lines(&self, gap: &str, is_last: bool, out: &mut String) {
        let mut lines = gap.split('\n').map(|line| line.trim_matches([' ', '\t', ',']));
        if let Some(comment) = lines.next().filter(|line| !line.is_empty()) {
            out.push(' ');
            out.push_str(comment);
        }
        let mut lines: Vec<&str> = lines.collect();
        lines.pop();
        lines.dedup_by(|next, line| next.is_empty() && line.is_empty());
        let indent = "    ".repeat(self.depth + 1);
        for line in lines {
            out.push('\n');
            if !line.is_empty() {
                out.push_str(&indent);
                out.push_str(line);
            }
        }
        out.push('\n');
        out.push_str(if is_last { indent.get(4..).unwrap_or_default() } else { &indent });
    }
}
