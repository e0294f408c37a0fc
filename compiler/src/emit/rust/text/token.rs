//! Tokens as the layout needs them: operators whole, and generics told from comparisons.

use proc_macro2::{Delimiter, Ident, Literal, Spacing, TokenStream, TokenTree};

/// A token, with what it encloses.
#[derive(Debug)]
pub(super) enum Token {
    Ident(Ident),
    Literal(Literal),
    Lifetime(Ident),
    /// An operator or another sign, as it is written.
    Sign(&'static str),
    /// The `<` of generics.
    Less,
    /// The `>` of generics.
    Greater,
    /// What is in parentheses, brackets or braces.
    Group(Delimiter, Vec<Token>),
}

impl Token {
    /// Whether it is this word.
    pub(super) fn is_word(&self, word: &str) -> bool {
        matches!(self, Self::Ident(ident) if ident == word)
    }

    /// Whether it is this sign.
    pub(super) fn is_sign(&self, sign: &str) -> bool {
        matches!(self, Self::Sign(known) if *known == sign)
    }

    /// Whether it would be another sign with this one right behind it.
    pub(super) fn joins(&self, sign: &str) -> bool {
        matches!((self, sign.chars().next()), (Self::Sign(first), Some(next)) if joined(first, next).is_some())
    }

    /// Whether it is something in braces.
    pub(super) fn is_braces(&self) -> bool {
        matches!(self, Self::Group(Delimiter::Brace, _))
    }
}

/// The tokens that are not in generics, each with its place.
pub(super) fn outside_generics(tokens: &[Token]) -> impl Iterator<Item = (usize, &Token)> {
    let mut depth = 0_usize;
    tokens.iter().enumerate().filter(move |(_, token)| {
        match token {
            Token::Less => depth += 1,
            Token::Greater => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0
    })
}

/// The tokens of a stream.
///
/// Streams and groups are used up before what is in them, so that nothing of it has to be copied.
pub(super) fn tokens(stream: TokenStream) -> Vec<Token> {
    let mut tokens = Vec::new();
    append(stream, &mut tokens);
    mark_generics(&mut tokens);
    tokens
}

fn append(stream: TokenStream, tokens: &mut Vec<Token>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Ident(ident) => tokens.push(Token::Ident(ident)),
            TokenTree::Literal(literal) => tokens.push(Token::Literal(literal)),
            TokenTree::Group(group) => {
                let (delimiter, stream) = (group.delimiter(), group.stream());
                drop(group);
                match delimiter {
                    Delimiter::None => append(stream, tokens),
                    _ => tokens.push(Token::Group(delimiter, self::tokens(stream))),
                }
            }
            TokenTree::Punct(first) => {
                let (mut sign, mut last) = (single(first.as_char()), first);
                while last.spacing() == Spacing::Joint
                    && let Some(TokenTree::Punct(next)) = trees.peek()
                    && let Some(longer) = joined(sign, next.as_char())
                {
                    sign = longer;
                    last = next.clone();
                    trees.next();
                }
                match trees.peek() {
                    Some(TokenTree::Ident(name)) if sign == "'" => {
                        tokens.push(Token::Lifetime(name.clone()));
                        trees.next();
                    }
                    _ => tokens.push(Token::Sign(sign)),
                }
            }
        }
    }
}

/// A sign of one character.
fn single(sign: char) -> &'static str {
    match sign {
        '!' => "!",
        '#' => "#",
        '$' => "$",
        '%' => "%",
        '&' => "&",
        '\'' => "'",
        '*' => "*",
        '+' => "+",
        ',' => ",",
        '-' => "-",
        '.' => ".",
        '/' => "/",
        ':' => ":",
        ';' => ";",
        '<' => "<",
        '=' => "=",
        '>' => ">",
        '?' => "?",
        '@' => "@",
        '^' => "^",
        '|' => "|",
        // the last sign there is
        _ => "~",
    }
}

/// A sign with another character, if that makes a sign too.
fn joined(sign: &str, next: char) -> Option<&'static str> {
    Some(match (sign, next) {
        (":", ':') => "::",
        ("-", '>') => "->",
        ("=", '>') => "=>",
        ("=", '=') => "==",
        ("!", '=') => "!=",
        ("<", '=') => "<=",
        (">", '=') => ">=",
        ("<", '<') => "<<",
        (">", '>') => ">>",
        ("<<", '=') => "<<=",
        (">>", '=') => ">>=",
        ("&", '&') => "&&",
        ("|", '|') => "||",
        (".", '.') => "..",
        ("..", '=') => "..=",
        ("..", '.') => "...",
        ("+", '=') => "+=",
        ("-", '=') => "-=",
        ("*", '=') => "*=",
        ("/", '=') => "/=",
        ("%", '=') => "%=",
        ("^", '=') => "^=",
        ("&", '=') => "&=",
        ("|", '=') => "|=",
        _ => return None,
    })
}

/// Tells the signs around generics from comparisons: the former come in pairs, and only types are between them.
fn mark_generics(tokens: &mut Vec<Token>) {
    let mut open: Vec<usize> = Vec::new();
    let (mut place, mut is_argument) = (0, false);
    while let Some(token) = tokens.get_mut(place) {
        let begins_argument = token.is_sign("<") || token.is_sign(",");
        match token {
            Token::Sign("<") => open.push(place),
            Token::Sign(">>") if open.len() > 1 => {
                *token = Token::Sign(">");
                tokens.insert(place, Token::Sign(">"));
                continue;
            }
            Token::Sign(">") => {
                if let Some(less) = open.pop() {
                    *token = Token::Greater;
                    tokens.get_mut(less).into_iter().for_each(|token| *token = Token::Less);
                }
            }
            Token::Sign(";" | "&&" | "||" | "==" | "!=" | "." | "=>" | "<=" | ">=") => open.clear(),
            Token::Group(Delimiter::Brace, _) if !is_argument => open.clear(),
            _ => {}
        }
        is_argument = begins_argument;
        place += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many pairs of signs are taken for those of generics.
    fn pairs(code: &str) -> usize {
        let tokens = tokens(code.parse().expect("the code has tokens"));
        let count = |wanted: fn(&&Token) -> bool| tokens.iter().filter(wanted).count();
        let pairs = count(|token| matches!(token, Token::Less));
        assert_eq!(pairs, count(|token| matches!(token, Token::Greater)), "{code}");
        pairs
    }

    #[test]
    fn generics_are_told_from_comparisons() {
        for (code, expected) in [
            ("a: Entry<C887, u32, ReadOnly>", 1),
            ("fn f<'a, T: ?Sized>(x: Vec<Vec<T>>) -> Option<&'a [T]>", 2),
            ("EntryInfo::list::<7>(a < b, c)", 1),
            ("a < b && c > d", 0),
            ("self.a < self.b", 0),
            ("x << 1 >> 2", 0),
            ("<T as Trait<{ N }>>::Item", 2),
            ("F: Fn(u8) -> Option<u8>", 1),
        ] {
            assert_eq!(pairs(code), expected, "{code}");
        }
    }

    #[test]
    fn operators_are_whole() {
        let tokens = tokens("a::b..=c => d << e".parse().expect("the code has tokens"));
        let signs: Vec<&str> = tokens
            .iter()
            .filter_map(|token| if let Token::Sign(sign) = token { Some(*sign) } else { None })
            .collect();
        assert_eq!(signs, ["::", "..=", "=>", "<<"]);
    }
}
