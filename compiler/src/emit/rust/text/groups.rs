//! What is in parentheses, brackets and braces.

use proc_macro2::Delimiter;

use super::Printer;
use super::document::Group;
use super::items::Place;
use super::token::{Token, outside_generics};

/// What a list is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// Arguments, parameters, an index.
    Call,
    /// A tuple, an array, an expression in parentheses.
    Tuple,
    /// The fields of a value or of a pattern.
    Fields,
    /// The names of a `use`.
    Imports,
    /// What a macro is given.
    Macro,
}

impl Printer {
    /// Writes a list with its brackets: on one line, or an item a line.
    pub(super) fn list(&mut self, delimiter: Delimiter, content: &[Token], shape: Shape) {
        let (opening, closing) = brackets(delimiter);
        self.document.text.push(opening);
        let was_exact = self.is_exact;
        self.is_exact |= shape == Shape::Macro;
        if delimiter == Delimiter::Bracket && content.iter().any(|token| token.is_sign(";")) {
            self.run(content, false);
        } else if !content.is_empty() {
            self.list_items(delimiter, content, shape);
        }
        self.is_exact = was_exact;
        self.document.text.push(closing);
    }

    fn list_items(&mut self, delimiter: Delimiter, content: &[Token], shape: Shape) {
        let items = split(content);
        let ends_with_comma = content.last().is_some_and(|token| token.is_sign(","));
        let is_single = items.len() == 1 && delimiter == Delimiter::Parenthesis && shape == Shape::Tuple;
        let keeps_comma = ends_with_comma && (self.is_exact || is_single);
        let is_rest = items.last().and_then(|item| item.first()).is_some_and(|token| token.is_sign(".."));
        let comma = !self.is_exact && !is_single && !is_rest;
        let is_words = !is_rest
            && (delimiter == Delimiter::Bracket || shape == Shape::Imports)
            && items.iter().all(|item| is_word(item));
        let space = if delimiter == Delimiter::Brace && shape != Shape::Imports { " " } else { "" };
        self.document.open(if is_words { Group::Words { comma } } else { Group::List { comma } }, space);
        self.each(items);
        if keeps_comma {
            self.document.text.push(',');
        }
        self.document.close(space);
    }

    /// Writes the fields or variants of a declaration with their braces, each on a line of its own.
    pub(super) fn fields(&mut self, content: &[Token]) {
        self.document.text.push('{');
        if !content.is_empty() {
            let comma = !self.is_exact || content.last().is_some_and(|token| token.is_sign(","));
            self.document.open(Group::List { comma }, " ");
            self.document.heighten();
            self.each(split(content));
            self.document.close(" ");
        }
        self.document.text.push('}');
    }

    /// Writes the bounds of a `where`, each on a line of its own.
    pub(super) fn bounds(&mut self, content: &[Token]) {
        self.document.line();
        self.document.text.push_str("where");
        self.document.open(Group::List { comma: true }, " ");
        self.document.heighten();
        self.each(split(content));
        self.document.close("");
    }

    /// Writes items with commas between them.
    fn each(&mut self, items: Vec<&[Token]>) {
        for (number, item) in items.into_iter().enumerate() {
            if number > 0 {
                self.document.text.push(',');
                self.document.next_item(" ");
            }
            let item = self.attributes(item);
            self.run(item, false);
        }
    }

    /// Writes a block with its braces: on one line only if it is a single expression of another one.
    pub(super) fn block(&mut self, content: &[Token], is_statement: bool) {
        self.document.text.push('{');
        if !content.is_empty() {
            self.document.open(Group::Block, " ");
            let is_expression = self.statements(content, Place::Body);
            if is_statement || !is_expression {
                self.document.heighten();
            }
            self.document.close(" ");
        }
        self.document.text.push('}');
    }

    /// Writes what a macro is given in braces: items or statements, or else a list.
    pub(super) fn macro_braces(&mut self, content: &[Token]) {
        let is_statement = |token: &Token| token.is_sign(";") || token.is_braces();
        if !content.iter().any(is_statement) {
            return self.list(Delimiter::Brace, content, Shape::Macro);
        }
        let was_exact = std::mem::replace(&mut self.is_exact, true);
        self.document.text.push('{');
        self.document.open(Group::Block, " ");
        self.document.heighten();
        self.statements(content, Place::Body);
        self.document.close(" ");
        self.document.text.push('}');
        self.is_exact = was_exact;
    }

    /// Writes the arms of a `match` with their braces, each on a line of its own.
    pub(super) fn arms(&mut self, mut content: &[Token]) {
        self.document.text.push('{');
        if !content.is_empty() {
            self.document.open(Group::Block, " ");
            self.document.heighten();
            loop {
                content = self.arm(content);
                if content.is_empty() {
                    break;
                }
                self.document.next_item(" ");
            }
            self.document.close(" ");
        }
        self.document.text.push('}');
    }

    /// Writes the first arm, and gives the others.
    fn arm<'a>(&mut self, content: &'a [Token]) -> &'a [Token] {
        let content = self.attributes(content);
        let Some(arrow) = content.iter().position(|token| token.is_sign("=>")) else {
            self.run(content, false);
            return &[];
        };
        let (pattern, value) = content.split_at(arrow);
        self.run(pattern, false);
        self.document.text.push_str(" =>");
        let value = value.get(1..).unwrap_or_default();
        if let [Token::Group(Delimiter::Brace, block), after @ ..] = value
            && !after.first().is_some_and(|next| next.is_sign(".") || next.is_sign("?"))
        {
            self.document.text.push(' ');
            self.block(block, true);
            let rest = after.split_first().filter(|(next, _)| next.is_sign(",")).map(|(_, rest)| rest);
            return rest.unwrap_or(after);
        }
        let (value, rest) = first_item(value);
        self.document.open(Group::Value, " ");
        self.run(value, false);
        self.document.close("");
        self.document.text.push(',');
        rest
    }
}

fn brackets(delimiter: Delimiter) -> (char, char) {
    match delimiter {
        Delimiter::Brace => ('{', '}'),
        Delimiter::Bracket => ('[', ']'),
        Delimiter::Parenthesis | Delimiter::None => ('(', ')'),
    }
}

/// The items that commas are between, without an empty one at the end.
fn split(mut content: &[Token]) -> Vec<&[Token]> {
    let mut items = Vec::new();
    while !content.is_empty() {
        let (item, rest) = first_item(content);
        items.push(item);
        content = rest;
    }
    items
}

/// The tokens up to the first comma that is not one of generics or of a closure, and those behind it.
fn first_item(content: &[Token]) -> (&[Token], &[Token]) {
    let (mut is_closure, mut is_value) = (false, false);
    let comma = outside_generics(content).find(|(_, token)| {
        if token.is_sign("|") {
            is_closure = !is_closure && !is_value;
        }
        is_value = !matches!(token, Token::Sign(_)) && !token.is_word("move");
        token.is_sign(",") && !is_closure
    });
    let (item, rest) = content.split_at(comma.map_or(content.len(), |(place, _)| place));
    (item, rest.get(1..).unwrap_or_default())
}

/// Whether it is a name or a number.
fn is_word(item: &[Token]) -> bool {
    match item {
        [Token::Ident(_) | Token::Literal(_)] => true,
        [sign, Token::Literal(_)] => sign.is_sign("-"),
        _ => false,
    }
}
