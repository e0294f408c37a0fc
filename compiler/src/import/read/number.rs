//! Numbers, truth and bytes as ESI files spell them.

/// `HexDecValue`: decimal, or hexadecimal after `#x`; some files write `0x` or `#x0x`.
pub(crate) fn number<T: TryFrom<i128>>(text: &str) -> Option<T> {
    let text = text.trim();
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let hex = strip(digits, "#x").or_else(|| strip(digits, "0x"));
    let value = match hex {
        Some(hex) => {
            let hex = strip(hex, "0x").unwrap_or(hex);
            hex.bytes().all(|byte| byte.is_ascii_hexdigit()).then(|| i128::from_str_radix(hex, 16).ok())?
        }
        None => digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())?,
    }?;
    T::try_from(if negative { -value } else { value }).ok()
}

fn strip<'t>(text: &'t str, prefix: &str) -> Option<&'t str> {
    let head = text.get(..prefix.len())?;
    head.eq_ignore_ascii_case(prefix).then(|| text.get(prefix.len()..)).flatten()
}

/// `1` or `true`.
pub(crate) fn truth(text: &str) -> Option<bool> {
    match text.trim() {
        "1" | "true" | "True" | "TRUE" => Some(true),
        "0" | "false" | "False" | "FALSE" => Some(false),
        _ => None,
    }
}

/// `hexBinary`: two digits a byte.
pub(crate) fn bytes(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u8> =
        text.chars().filter(|char| !char.is_whitespace()).map(digit).collect::<Option<_>>()?;
    let whole = digits.len().is_multiple_of(2);
    whole.then(|| digits.chunks(2).map(|pair| pair.iter().fold(0, |byte, digit| byte << 4 | digit)).collect())
}

fn digit(char: char) -> Option<u8> {
    char.to_digit(16).and_then(|digit| u8::try_from(digit).ok())
}
