//! Items and statements, one below the other.

use super::Printer;
use super::document::Group;
use super::lines::WIDTH;
use super::statement::{Body, Kind, Statement};
use super::token::{Token, outside_generics};

/// Where items or statements stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// In a module, an implementation, a trait.
    Items,
    /// In a block.
    Body,
}

/// The columns that a constant may have to stand close to others.
const SHORT: usize = 80;

/// How much an item is to the eye.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Look {
    /// A short line.
    Short,
    /// A line of documentation, and the item below it, on one line or with its value on the next.
    Documented,
    /// More than that.
    Long,
}

impl Look {
    /// The look of an item of this length, below so many lines of attributes.
    fn of(lines: usize, length: usize) -> Self {
        match lines {
            0 if length <= SHORT => Self::Short,
            1 if length <= WIDTH => Self::Documented,
            _ => Self::Long,
        }
    }
}

impl Printer {
    /// Writes items or statements, and says whether they are but one expression.
    pub(super) fn statements(&mut self, tokens: &[Token], place: Place) -> bool {
        let mut rest = self.inner_attributes(tokens);
        let mut before: Option<(Kind, Look)> = None;
        let mut is_expression = rest.len() == tokens.len();
        while !rest.is_empty() {
            let between = before.map(|_| self.document.next_item(""));
            let marks = self.document.marks.len();
            let tokens = self.attributes(rest);
            let (lines, start) = (self.document.marks.len() - marks, self.document.text.len());
            let statement;
            (statement, rest) = Statement::first(tokens);
            self.statement(&statement);
            is_expression &= before.is_none() && is_expression_of(&statement);
            let this = (statement.kind, Look::of(lines, self.document.text.len() - start));
            if let (Some(before), Some(between)) = (before, between)
                && !is_close(before, this, place)
            {
                self.document.set_apart(between);
            }
            before = Some(this);
        }
        is_expression
    }

    fn statement(&mut self, statement: &Statement<'_>) {
        match statement.kind {
            Kind::Item(body) => self.item(statement.tokens, body),
            Kind::Import | Kind::Macro => self.run(statement.tokens, true),
            Kind::Control => self.run(statement.tokens, true),
            Kind::Constant | Kind::Alias | Kind::Expression => self.assignment(statement.tokens),
        }
    }

    /// Writes what may have a value behind a `=`.
    fn assignment(&mut self, tokens: &[Token]) {
        let Some(equals) = assigned(tokens) else { return self.run(tokens, false) };
        let (target, value) = tokens.split_at(equals);
        let (sign, value) = value.split_at_checked(1).unwrap_or_default();
        self.run(target, false);
        self.document.text.push(' ');
        self.run(sign, false);
        self.document.open(Group::Value, " ");
        match value.split_last() {
            Some((end, value)) if end.is_sign(";") => {
                self.run(value, false);
                self.document.close("");
                self.document.text.push(';');
            }
            _ => {
                self.run(value, false);
                self.document.close("");
            }
        }
    }

    /// Writes an item with its body.
    fn item(&mut self, tokens: &[Token], body: Body) {
        let (head, end) = match tokens.split_last() {
            Some((end, head)) if end.is_braces() || end.is_sign(";") => (head, Some(end)),
            _ => (tokens, None),
        };
        let bounds = head.iter().position(|token| token.is_word("where"));
        let (head, bounds) = head.split_at(bounds.unwrap_or(head.len()));
        self.run(head, false);
        if let Some((_, bounds)) = bounds.split_first() {
            self.bounds(bounds);
        }
        match end {
            Some(Token::Group(_, content)) => {
                if bounds.is_empty() {
                    self.document.text.push(' ');
                }
                self.body(content, body);
            }
            Some(_) => self.document.text.push(';'),
            None => {}
        }
    }

    fn body(&mut self, content: &[Token], body: Body) {
        match body {
            Body::Statements => self.block(content, true),
            Body::Fields => self.fields(content),
            Body::Items if content.is_empty() => self.document.text.push_str("{}"),
            Body::Items => {
                self.document.text.push('{');
                self.document.open(Group::Block, " ");
                self.document.heighten();
                self.statements(content, Place::Items);
                self.document.close(" ");
                self.document.text.push('}');
            }
        }
    }
}

/// Whether it has a value, so that it can be all that is in a block.
fn is_expression_of(statement: &Statement<'_>) -> bool {
    matches!(statement.kind, Kind::Expression | Kind::Macro)
        && !statement.tokens.last().is_some_and(|last| last.is_sign(";"))
}

/// Where a value is assigned, not where an operator compares or a parameter has a default.
fn assigned(tokens: &[Token]) -> Option<usize> {
    let is_assignment = |token: &Token| {
        matches!(token, Token::Sign(sign)
            if sign.ends_with('=') && !matches!(*sign, "==" | "!=" | "<=" | ">=" | "..="))
    };
    outside_generics(tokens).find(|(_, token)| is_assignment(token)).map(|(place, _)| place)
}

/// Whether no empty line is to be between two items or statements, each with its look.
fn is_close(before: (Kind, Look), this: (Kind, Look), place: Place) -> bool {
    let is_item = |kind| matches!(kind, Kind::Item(_));
    let is_alike = before.0 == this.0 && before.1 == this.1 && this.1 != Look::Long;
    match (place, this.0) {
        (Place::Body, _) => !is_item(before.0) && !is_item(this.0) || is_alike && this.1 == Look::Short,
        (Place::Items, Kind::Import) => before.0 == Kind::Import,
        (Place::Items, Kind::Constant) => is_alike,
        (Place::Items, Kind::Alias) => is_alike && this.1 == Look::Short,
        (Place::Items, _) => false,
    }
}
