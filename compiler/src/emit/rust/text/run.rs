//! Tokens in a row, as an expression or a type: which have spaces between them, and where a line may end.

use proc_macro2::Delimiter;

use super::Printer;
use super::document::Group;
use super::groups::Shape;
use super::token::Token;

/// What stands before a token, as far as a space depends on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Before {
    /// Nothing, or what takes no space behind it.
    Tight,
    /// What can be called, indexed, or be the left side of an operator.
    Value,
    /// A keyword.
    Word,
    /// An operator.
    Sign,
    /// The `!` of a macro.
    Bang,
}

/// What the braces hold that come next.
#[derive(Debug, Clone, Copy)]
enum Body {
    Block,
    Arms,
}

/// How far a row of tokens is written.
#[derive(Debug)]
struct Run<'a> {
    before: Before,
    last: Option<&'a Token>,
    /// What a word has announced.
    body: Option<Body>,
    /// Whether the parameters of a closure have begun and not ended.
    is_closure: bool,
    /// What each of the generics that have begun and not ended leaves behind it.
    generics: Vec<Before>,
    /// Whether blocks are never on one line.
    is_statement: bool,
}

impl Printer {
    /// Writes tokens in a row; the blocks of a statement are never on one line.
    pub(super) fn run(&mut self, tokens: &[Token], is_statement: bool) {
        let before = Before::Tight;
        let mut run =
            Run { before, last: None, body: None, is_closure: false, generics: Vec::new(), is_statement };
        let mut rest = tokens;
        while let [token, after @ ..] = rest {
            match token {
                Token::Ident(_) => self.word(token, after, &mut run),
                Token::Literal(literal) => {
                    self.gap(run.before != Before::Tight);
                    self.document.write(literal);
                    run.before = Before::Value;
                }
                Token::Lifetime(name) => {
                    self.gap(run.before != Before::Tight);
                    self.document.write(format_args!("'{name}"));
                    run.before = Before::Word;
                }
                Token::Less => self.less(&mut run),
                Token::Greater => self.greater(&mut run),
                Token::Sign(",") => self.comma(after, &mut run),
                Token::Sign(sign) => self.sign(sign, after, &mut run),
                Token::Group(Delimiter::Brace, content) => self.braces(content, after, &mut run),
                Token::Group(delimiter, content) => {
                    self.gap(matches!(run.before, Before::Word | Before::Sign));
                    let shape = match run.before {
                        Before::Bang => Shape::Macro,
                        Before::Value => Shape::Call,
                        _ => Shape::Tuple,
                    };
                    self.list(*delimiter, content, shape);
                    run.before = Before::Value;
                }
            }
            run.last = Some(token);
            rest = after;
        }
        while !run.generics.is_empty() {
            self.greater(&mut run);
        }
    }

    fn less(&mut self, run: &mut Run<'_>) {
        let is_bound = run.last.is_some_and(|last| last.is_word("impl") || last.is_word("for"));
        self.gap(!is_bound && matches!(run.before, Before::Word | Before::Sign));
        self.document.text.push('<');
        self.document.open(Group::Generics { comma: !self.is_exact }, "");
        run.generics.push(if is_bound { Before::Word } else { Before::Value });
        run.before = Before::Tight;
    }

    fn greater(&mut self, run: &mut Run<'_>) {
        self.document.close("");
        self.document.text.push('>');
        run.before = run.generics.pop().unwrap_or(Before::Value);
    }

    /// Writes a comma that is not in a list: in generics, between the parameters of a closure.
    fn comma(&mut self, after: &[Token], run: &mut Run<'_>) {
        let is_last = matches!(after.first(), Some(Token::Greater));
        if is_last && !self.is_exact {
            return;
        }
        self.document.text.push(',');
        run.before = Before::Sign;
        if !is_last && !run.generics.is_empty() {
            self.document.next_item(" ");
            run.before = Before::Tight;
        }
    }

    fn word(&mut self, token: &Token, after: &[Token], run: &mut Run<'_>) {
        let Token::Ident(ident) = token else { return };
        self.gap(run.before != Before::Tight);
        let start = self.document.text.len();
        self.document.write(ident);
        let is_member = run.last.is_some_and(|last| last.is_sign("."));
        let word = self.document.text.get(start..).filter(|_| !is_member).unwrap_or_default();
        match word {
            "match" => run.body = Some(Body::Arms),
            "if" | "else" | "while" | "for" | "loop" | "unsafe" | "async" => run.body = Some(Body::Block),
            "const" if after.first().is_some_and(Token::is_braces) => run.body = Some(Body::Block),
            _ => {}
        }
        run.before = if is_keyword(word) { Before::Word } else { Before::Value };
    }

    fn sign(&mut self, sign: &'static str, after: &[Token], run: &mut Run<'_>) {
        let is_value = run.before == Before::Value;
        let is_apart = matches!(run.before, Before::Word | Before::Sign);
        let next = after.first();
        let (gap, before) = match sign {
            ";" | ":" => (false, Before::Sign),
            "." => (false, Before::Tight),
            "?" if is_value => (false, Before::Value),
            "!" if is_value && matches!(next, Some(Token::Group(..) | Token::Ident(_))) => {
                (false, Before::Bang)
            }
            // the type of what never returns
            "!" if next.is_none_or(Token::is_braces) => (is_apart, Before::Value),
            "|" if run.is_closure => (false, Before::Sign),
            "||" if !is_value => (is_apart, Before::Sign),
            "&" | "&&" | "*" | "-" | "|" if !is_value => (is_apart, Before::Tight),
            "::" | ".." | "..=" | "..." | "?" | "!" => (is_apart, Before::Tight),
            "#" | "$" | "'" | "~" => (run.before != Before::Tight, Before::Tight),
            _ => (run.before != Before::Tight, Before::Sign),
        };
        match sign {
            "|" => run.is_closure = !run.is_closure && !is_value,
            "->" => run.body = Some(Body::Block),
            "=>" => run.body = None,
            _ => {}
        }
        match sign {
            "&&" | "||" | "|" | "+" if is_value && gap => self.document.soft(" "),
            "." if is_method(after) => self.document.soft(""),
            _ => self.gap(gap || run.last.is_some_and(|last| last.joins(sign))),
        }
        self.document.text.push_str(sign);
        run.before = before;
    }

    fn braces(&mut self, content: &[Token], after: &[Token], run: &mut Run<'_>) {
        let is_path = run.last.is_some_and(|last| last.is_sign("::"));
        self.gap(run.before != Before::Tight);
        // a pattern in the head of what has a block
        let is_pattern = after.first().is_some_and(|next| next.is_sign("=") || next.is_word("in"));
        match run.body.filter(|_| !is_pattern) {
            Some(Body::Block) => self.block(content, run.is_statement),
            Some(Body::Arms) => self.arms(content),
            None if run.before == Before::Bang => self.macro_braces(content),
            None if is_path => self.list(Delimiter::Brace, content, Shape::Imports),
            None if run.before == Before::Value => self.list(Delimiter::Brace, content, Shape::Fields),
            None => self.block(content, run.is_statement),
        }
        if !is_pattern {
            run.body = None;
        }
        run.before = Before::Value;
    }

    fn gap(&mut self, is_gap: bool) {
        if is_gap {
            self.document.text.push(' ');
        }
    }
}

/// Whether the tokens behind a dot call a method.
fn is_method(after: &[Token]) -> bool {
    let call = after.get(1);
    matches!(after.first(), Some(Token::Ident(_)))
        && call
            .is_some_and(|call| call.is_sign("::") || matches!(call, Token::Group(Delimiter::Parenthesis, _)))
}

/// Whether something comes behind the word that a space is to stand before; `fn` and `pub` go with parentheses.
fn is_keyword(word: &str) -> bool {
    matches!(
        word,
        "as" | "async"
            | "break"
            | "const"
            | "continue"
            | "dyn"
            | "else"
            | "enum"
            | "extern"
            | "for"
            | "if"
            | "impl"
            | "in"
            | "let"
            | "loop"
            | "match"
            | "mod"
            | "move"
            | "mut"
            | "ref"
            | "return"
            | "static"
            | "struct"
            | "trait"
            | "type"
            | "unsafe"
            | "use"
            | "where"
            | "while"
            | "yield"
    )
}
