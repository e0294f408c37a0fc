//! Where items and statements end, and what they are.

use proc_macro2::Delimiter;

use super::token::{Token, outside_generics};

/// An item or a statement.
#[derive(Debug)]
pub(super) struct Statement<'a> {
    pub(super) kind: Kind,
    /// All tokens behind the attributes, with the semicolon.
    pub(super) tokens: &'a [Token],
}

/// What an item or a statement is, as far as its layout depends on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A `use`, or a module elsewhere.
    Import,
    Constant,
    /// A name for a type.
    Alias,
    /// What has a body in braces, or ends without one.
    Item(Body),
    /// The invocation of a macro.
    Macro,
    /// An expression that ends with its block.
    Control,
    /// A `let`, or an expression.
    Expression,
}

/// What is in the braces of an item.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Body {
    Items,
    Statements,
    Fields,
}

impl<'a> Statement<'a> {
    /// The first statement of some without attributes, and those behind it.
    pub(super) fn first(tokens: &'a [Token]) -> (Self, &'a [Token]) {
        let kind = kind(tokens);
        let length = match kind {
            Kind::Item(_) => ends_with_braces(tokens),
            Kind::Control => ends_with_block(tokens),
            Kind::Macro => ends_macro(tokens),
            Kind::Import | Kind::Constant | Kind::Alias | Kind::Expression => ends_with_semicolon(tokens),
        };
        let (statement, rest) = tokens.split_at_checked(length).unwrap_or((tokens, &[]));
        (Self { kind, tokens: statement }, rest)
    }
}

fn kind(tokens: &[Token]) -> Kind {
    let mut words = visible(tokens);
    while let [word, after @ ..] = words {
        let next = after.first();
        let Token::Ident(ident) = word else { break };
        match ident.to_string().as_str() {
            "use" => return Kind::Import,
            "mod" if after.get(1).is_some_and(|end| end.is_sign(";")) => return Kind::Import,
            "mod" | "impl" | "trait" => return Kind::Item(Body::Items),
            "fn" => return Kind::Item(Body::Statements),
            "struct" | "enum" => return Kind::Item(Body::Fields),
            "union" if matches!(next, Some(Token::Ident(_))) => return Kind::Item(Body::Fields),
            "type" => return Kind::Alias,
            "static" => return Kind::Constant,
            "const" | "unsafe" | "async" if next.is_some_and(Token::is_braces) => return Kind::Control,
            "const" if !next.is_some_and(is_qualifier) => return Kind::Constant,
            "const" | "unsafe" | "async" => words = after,
            "extern" => match after {
                [Token::Literal(_), Token::Group(..), ..] => return Kind::Item(Body::Items),
                [Token::Literal(_), after @ ..] => words = after,
                _ => return Kind::Import,
            },
            "if" | "match" | "loop" | "while" | "for" => return Kind::Control,
            _ => break,
        }
    }
    match words.first() {
        Some(Token::Lifetime(_) | Token::Group(Delimiter::Brace, _)) => Kind::Control,
        _ if is_macro(words) => Kind::Macro,
        _ => Kind::Expression,
    }
}

/// The tokens behind `pub` and what it is restricted to.
fn visible(tokens: &[Token]) -> &[Token] {
    match tokens {
        [public, Token::Group(Delimiter::Parenthesis, _), rest @ ..] if public.is_word("pub") => rest,
        [public, rest @ ..] if public.is_word("pub") => rest,
        _ => tokens,
    }
}

/// Whether the word stands between `const` and `fn`, or is the latter.
fn is_qualifier(token: &Token) -> bool {
    ["fn", "unsafe", "async", "extern"].iter().any(|word| token.is_word(word))
}

/// Whether a path and a `!` come first.
fn is_macro(tokens: &[Token]) -> bool {
    let mut behind = tokens.iter().skip_while(|token| matches!(token, Token::Ident(_) | Token::Sign("::")));
    behind.next().is_some_and(|token| token.is_sign("!"))
        && !tokens.first().is_some_and(|token| token.is_sign("!"))
}

fn ends_with_semicolon(tokens: &[Token]) -> usize {
    tokens.iter().position(|token| token.is_sign(";")).map_or(tokens.len(), |place| place + 1)
}

fn ends_with_braces(tokens: &[Token]) -> usize {
    let end = outside_generics(tokens).find(|(_, token)| token.is_sign(";") || token.is_braces());
    end.map_or(tokens.len(), |(place, _)| place + 1)
}

/// Behind the block with which the expression ends: not behind a pattern, nor before another branch.
fn ends_with_block(tokens: &[Token]) -> usize {
    let mut blocks =
        outside_generics(tokens).filter(|(_, token)| token.is_braces()).map(|(place, _)| place + 1);
    let goes_on = |end: &usize| match tokens.get(*end) {
        Some(Token::Sign(sign)) => matches!(*sign, "=" | "." | "?"),
        Some(next) => next.is_word("else") || next.is_word("in"),
        None => false,
    };
    let end = blocks.find(|end| !goes_on(end)).unwrap_or(tokens.len());
    match tokens.get(end) {
        Some(next) if next.is_sign(";") => end + 1,
        _ => end,
    }
}

/// Behind the braces of a macro; with other brackets it ends as an expression does.
fn ends_macro(tokens: &[Token]) -> usize {
    let group = tokens.iter().position(|token| matches!(token, Token::Group(..)));
    let end = group.filter(|place| tokens.get(*place).is_some_and(Token::is_braces)).map(|place| place + 1);
    let goes_on = |end: &usize| tokens.get(*end).is_some_and(|next| next.is_sign(".") || next.is_sign("?"));
    end.filter(|end| !goes_on(end)).unwrap_or_else(|| ends_with_semicolon(tokens))
}
