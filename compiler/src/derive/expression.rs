//! Expressions in attributes and types.

use proc_macro2::{TokenStream, TokenTree};
use syn::parse::ParseStream;
use syn::parse::discouraged::Speculative;
use syn::{Error, Expr, ExprLit, Lit, LitStr, Result, Token};

/// Reads an expression. Without its feature `full` syn reads only a part of them: of others this is all up to the
/// comma, and rustc says what may be wrong with it.
pub(super) fn expression(input: ParseStream<'_>) -> Result<Expr> {
    let ahead = input.fork();
    if let Ok(expression) = ahead.parse() {
        input.advance_to(&ahead);
        return Ok(expression);
    }
    let missing = input.error("expected an expression");
    let tokens = up_to_comma(input)?;
    if tokens.is_empty() { Err(missing) } else { Ok(Expr::Verbatim(tokens)) }
}

/// Takes what is left before the next comma.
pub(super) fn up_to_comma(input: ParseStream<'_>) -> Result<TokenStream> {
    let mut tokens = TokenStream::new();
    while !input.is_empty() && !input.peek(Token![,]) {
        tokens.extend([input.parse::<TokenTree>()?]);
    }
    Ok(tokens)
}

/// Refuses what is left before the next comma.
pub(super) fn check_end(input: ParseStream<'_>) -> Result<()> {
    let is_end = input.is_empty() || input.peek(Token![,]);
    if is_end { Ok(()) } else { Err(input.error("expected a comma")) }
}

/// An expression without the marks around it of a macro that it comes from, and without parentheses.
pub(super) fn bare(mut value: &Expr) -> &Expr {
    loop {
        value = match value {
            Expr::Group(group) => &group.expr,
            Expr::Paren(paren) => &paren.expr,
            value => return value,
        }
    }
}

/// The text that an expression is.
pub(super) fn text(value: &Expr) -> Option<&LitStr> {
    match bare(value) {
        Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text),
        _ => None,
    }
}

/// The number from 1 to 255 in digits that an expression is; `of` says what is counted.
pub(super) fn number(value: &Expr, of: &str) -> Result<u8> {
    let number = match bare(value) {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse().ok(),
        _ => None,
    };
    let expected = || {
        let message = format!("expected the number of {of} in digits, from 1 to 255");
        Error::new_spanned(value, message)
    };
    number.filter(|number| *number > 0).ok_or_else(expected)
}
