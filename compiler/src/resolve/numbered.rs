//! Texts that hold for a range of subindices.

use crate::model::{Translation, Translations};

/// The text for one subindex: `{}` in it is the subindex, `{+8}` and `{-1}` are the subindex with a number added or
/// taken away. None if a brace holds anything else, or nothing closes it.
pub(super) fn numbered(text: &str, subindex: u8) -> Option<String> {
    let (mut out, mut rest) = (String::with_capacity(text.len() + 4), text);
    rest.contains('{').then_some(())?;
    while let Some((before, braced)) = rest.split_once('{') {
        let (offset, after) = braced.split_once('}')?;
        let offset = match offset {
            "" => 0,
            signed if signed.starts_with(['+', '-']) => signed.parse::<i16>().ok()?,
            _ => return None,
        };
        let number = i16::from(subindex).checked_add(offset)?;
        out.push_str(before);
        out.push_str(&number.to_string());
        rest = after;
    }
    out.push_str(rest);
    Some(out)
}

/// The text for one of several subindices; as it stands where it has no braces that make sense.
pub(super) fn of(text: &str, subindex: u8) -> String {
    numbered(text, subindex).unwrap_or_else(|| text.to_owned())
}

/// The name of one of several entries: numbered by its braces, or behind it.
pub(super) fn name(name: &str, subindex: u8) -> String {
    if name.contains('{') { of(name, subindex) } else { format!("{name} {subindex}") }
}

/// The names of one of several entries in other languages.
pub(super) fn names(names: &Translations, subindex: u8) -> Translations {
    let numbered = |it: &Translation| Translation { text: name(&it.text, subindex), ..it.clone() };
    Translations(names.iter().map(numbered).collect())
}

#[cfg(test)]
mod tests {
    use super::numbered;

    #[test]
    fn braces_are_numbers() {
        assert_eq!(numbered("DPRVAR{}", 3).as_deref(), Some("DPRVAR3"));
        assert_eq!(numbered("A619[{-1}]", 20).as_deref(), Some("A619[19]"));
        assert_eq!(numbered("{} of {+8} ({+8})", 1).as_deref(), Some("1 of 9 (9)"));
    }

    #[test]
    fn other_braces_are_not() {
        for text in ["DPRVAR", "a {b}", "{+}", "{8}", "{", "{} and {x}"] {
            assert_eq!(numbered(text, 1), None, "{text}");
        }
    }
}
