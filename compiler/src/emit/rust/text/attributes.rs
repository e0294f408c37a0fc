//! Attributes, and among them documentation.

use proc_macro2::Delimiter;

use super::Printer;
use super::token::Token;

impl Printer {
    /// Writes the attributes that the tokens begin with, a line each, and gives the other tokens.
    pub(super) fn attributes<'a>(&mut self, mut tokens: &'a [Token]) -> &'a [Token] {
        while let [hash, Token::Group(Delimiter::Bracket, content), rest @ ..] = tokens
            && hash.is_sign("#")
        {
            self.attribute(content, "///", "#[");
            self.document.line();
            tokens = rest;
        }
        tokens
    }

    /// Writes the attributes of the module that the tokens stand in, an item each, and gives the other tokens.
    pub(super) fn inner_attributes<'a>(&mut self, mut tokens: &'a [Token]) -> &'a [Token] {
        let mut last = None;
        while let [hash, bang, Token::Group(Delimiter::Bracket, content), rest @ ..] = tokens
            && hash.is_sign("#")
            && bang.is_sign("!")
        {
            self.attribute(content, "//!", "#![");
            tokens = rest;
            last = (!tokens.is_empty()).then(|| self.document.next_item(""));
        }
        if let Some(last) = last {
            self.document.set_apart(last);
            self.document.heighten();
        }
        tokens
    }

    fn attribute(&mut self, content: &[Token], comment: &str, opening: &str) {
        if let [name, equals, Token::Literal(text)] = content
            && name.is_word("doc")
            && equals.is_sign("=")
            && let Some(text) = comment_text(&text.to_string())
        {
            for (number, line) in text.split('\n').enumerate() {
                if number > 0 {
                    self.document.line();
                }
                self.document.text.push_str(comment);
                self.document.text.push_str(line);
            }
            return self.document.heighten();
        }
        self.document.text.push_str(opening);
        let was_exact = std::mem::replace(&mut self.is_exact, true);
        self.run(content, false);
        self.is_exact = was_exact;
        self.document.text.push(']');
    }
}

/// What a literal says, if comments can say it too, one for each of its lines.
fn comment_text(literal: &str) -> Option<String> {
    let text = match literal.strip_prefix('r') {
        Some(raw) => raw.trim_matches('#').strip_prefix('"')?.strip_suffix('"')?.to_owned(),
        None => unescaped(literal.strip_prefix('"')?.strip_suffix('"')?)?,
    };
    // with a slash more it would be no documentation
    (!text.split('\n').any(|line| line.starts_with('/')) && !text.contains('\r')).then_some(text)
}

/// The text without the escapes of a literal; none if there is one that no comment can say.
fn unescaped(escaped: &str) -> Option<String> {
    let mut text = String::with_capacity(escaped.len());
    let mut parts = escaped.split('\\');
    text.push_str(parts.next()?);
    while let Some(part) = parts.next() {
        let mut chars = part.chars();
        match chars.next() {
            // a backslash that is escaped: what follows it is as it is
            None => {
                text.push('\\');
                text.push_str(parts.next()?);
                continue;
            }
            Some('n') => text.push('\n'),
            Some('t') => text.push('\t'),
            Some('u') => {
                let (code, rest) = chars.as_str().strip_prefix('{')?.split_once('}')?;
                text.push(char::from_u32(u32::from_str_radix(code, 16).ok()?)?);
                chars = rest.chars();
            }
            Some(quote @ ('"' | '\'')) => text.push(quote),
            Some(_) => return None,
        }
        text.push_str(chars.as_str());
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use proc_macro2::Literal;

    use super::comment_text;

    #[test]
    fn a_comment_says_what_the_literal_says() {
        for text in [
            "",
            " plain",
            " \"quoted\" \\_ 'x'",
            " a\\\\b",
            " tab\tθ\u{301} \u{200b}",
            " ends with \\",
            " two\n\n lines",
        ] {
            assert_eq!(comment_text(&Literal::string(text).to_string()).as_deref(), Some(text));
        }
    }

    #[test]
    fn raw_literals_have_no_escapes() {
        assert_eq!(comment_text(r####"r##" a "#" \n "##"####).as_deref(), Some(r##" a "#" \n "##));
        assert_eq!(comment_text("b\" bytes\""), None);
    }

    #[test]
    fn what_a_comment_cannot_say_stays_an_attribute() {
        for text in ["/ four slashes", "two\n/ lines", "\r", "\0"] {
            assert_eq!(comment_text(&Literal::string(text).to_string()), None, "{text:?}");
        }
    }
}
