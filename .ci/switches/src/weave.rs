//! Changes and the code that they change, in one text: what runs is what the switch says.

use std::ops::Range;

use serde::Deserialize;

use crate::nodes::{Choice, Node, Nodes};

/// A change as cargo-mutants lists it.
#[derive(Deserialize)]
pub struct Change {
    pub file: String,
    genre: String,
    replacement: String,
    span: Span,
    function: Option<Function>,
}

#[derive(Deserialize)]
struct Function {
    return_type: String,
}

#[derive(Deserialize)]
struct Span {
    start: Point,
    end: Point,
}

/// Counted in characters, from 1.
#[derive(Deserialize)]
struct Point {
    line: usize,
    column: usize,
}

/// Something put into the text.
struct Piece {
    at: usize,
    /// What ends goes before what starts at the same place.
    ends: bool,
    /// Of what it is put around: outer pieces start first and end last.
    size: usize,
    text: String,
    /// The change that it belongs to; none for brackets.
    number: Option<usize>,
}

/// A text with switches, and which bytes of it belong to which change.
pub struct Woven {
    pub text: String,
    pub places: Vec<(Range<usize>, usize)>,
}

/// Around everything else at its place.
const OUTSIDE: usize = usize::MAX;
/// Around everything but the switch of the whole arm.
const GUARD: usize = usize::MAX / 2;

pub struct Weaver<'t> {
    text: &'t str,
    lines: Vec<usize>,
    nodes: Nodes,
    pieces: Vec<Piece>,
    /// Expressions that are written in several ways.
    varied: Vec<Range<usize>>,
}

impl<'t> Weaver<'t> {
    pub fn new(text: &'t str) -> syn::Result<Self> {
        let nodes = Nodes::of(&syn::parse_file(text)?);
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Ok(Self { text, lines, nodes, pieces: Vec::new(), varied: Vec::new() })
    }

    /// Puts a change behind its switch; false for one that only a build of its own can show.
    pub fn weave(&mut self, number: usize, change: &Change) -> bool {
        let span = self.byte(&change.span.start)..self.byte(&change.span.end);
        match change.genre.as_str() {
            "FnValue" => self.body(number, span, change),
            "MatchArm" => self.arm(number, span),
            "MatchArmGuard" => self.guard(number, span, change.replacement == "true"),
            "StructField" => {
                let found = self.nodes.fields.iter().find(|field| field.named.start == span.start);
                let comma = self.text[span.end..].trim_start().starts_with(',');
                let end =
                    span.end + if comma { self.text[span.end..].find(',').map_or(0, |at| at + 1) } else { 0 };
                found
                    .map(|Node { whole, .. }| whole.clone())
                    .is_some_and(|whole| self.instead(number, whole, span.start..end, ""))
            }
            _ => {
                let found = self.nodes.operators.iter().find(|operator| operator.named == span);
                let whole = found.map(|Node { whole, .. }| whole.clone());
                whole.is_some_and(|whole| self.instead(number, whole, span, &change.replacement))
            }
        }
    }

    fn byte(&self, point: &Point) -> usize {
        let line = self.lines[point.line - 1];
        line + self.text[line..].chars().take(point.column - 1).map(char::len_utf8).sum::<usize>()
    }

    fn put(&mut self, at: usize, ends: bool, size: usize, text: String, number: Option<usize>) {
        self.pieces.push(Piece { at, ends, size, text, number });
    }

    /// A function that returns something else at once. What iterates keeps its type and loses its items.
    fn body(&mut self, number: usize, span: Range<usize>, change: &Change) -> bool {
        let returns = change.function.as_ref().map_or("", |function| &function.return_type);
        let other = &change.replacement;
        if !returns.contains("impl ") {
            let text = format!("if crate::switch::on({number}) {{ return {other}; }} ");
            self.put(span.start, false, OUTSIDE, text, Some(number));
            return true;
        }
        if other == "::std::iter::empty()" {
            self.put(span.start, false, OUTSIDE, "({ ".to_owned(), Some(number));
            let text = format!(" }}).filter(|_| !crate::switch::on({number}))");
            self.put(span.end, true, OUTSIDE, text, Some(number));
            return true;
        }
        false
    }

    /// An expression of which a part is written in another way.
    fn instead(&mut self, number: usize, whole: Range<usize>, part: Range<usize>, by: &str) -> bool {
        let (before, after) = (&self.text[whole.start..part.start], &self.text[part.end..whole.end]);
        let text = format!("if crate::switch::on({number}) {{ {before} {by} {after} }} else ");
        if !self.varied.contains(&whole) {
            self.put(whole.start, false, whole.len(), "(".to_owned(), None);
            self.put(whole.end, true, whole.len(), " })".to_owned(), None);
            self.varied.push(whole.clone());
        }
        self.put(whole.start, false, whole.len(), text, Some(number));
        true
    }

    /// An arm that never matches.
    fn arm(&mut self, number: usize, span: Range<usize>) -> bool {
        let Some(arm) = self.nodes.arms.iter().find(|arm| arm.start == span.start) else { return false };
        let Choice { pattern_end, guard, .. } = arm;
        match guard.clone() {
            None => {
                let text = format!(" if !crate::switch::on({number})");
                self.put(*pattern_end, true, OUTSIDE, text, Some(number));
            }
            Some(guard) => {
                let text = format!("!crate::switch::on({number}) && (");
                self.put(guard.start, false, OUTSIDE, text, Some(number));
                self.put(guard.end, true, OUTSIDE, ")".to_owned(), None);
            }
        }
        true
    }

    fn guard(&mut self, number: usize, span: Range<usize>, holds: bool) -> bool {
        let (not, how) = if holds { ("", "||") } else { ("!", "&&") };
        let text = format!("{not}crate::switch::on({number}) {how} (");
        self.put(span.start, false, GUARD, text, Some(number));
        self.put(span.end, true, GUARD, ")".to_owned(), None);
        true
    }

    pub fn finish(mut self) -> Woven {
        // the text itself stands in the last branch
        for whole in std::mem::take(&mut self.varied) {
            self.put(whole.start, false, whole.len(), "{ ".to_owned(), None);
        }
        self.pieces.sort_by_key(|piece| {
            (piece.at, !piece.ends, if piece.ends { piece.size } else { usize::MAX - piece.size })
        });
        let (mut text, mut places, mut from) = (String::new(), Vec::new(), 0);
        for piece in self.pieces {
            text += &self.text[from..piece.at];
            from = piece.at;
            let start = text.len();
            text += &piece.text;
            places.extend(piece.number.map(|number| (start..text.len(), number)));
        }
        text += &self.text[from..];
        Woven { text, places }
    }
}
