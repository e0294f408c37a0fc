//! Numbers for people, exact to the last digit.

/// A whole number in groups of three digits, kept on one line.
pub(super) fn grouped(number: i128) -> String {
    let digits = number.unsigned_abs().to_string();
    let mut out = String::from(if number < 0 { "−" } else { "" });
    for (place, digit) in digits.chars().enumerate() {
        let left = digits.len() - place;
        if place > 0 && left.is_multiple_of(3) && digits.len() > 4 {
            out.push('\u{202F}');
        }
        out.push(digit);
    }
    out
}

/// A fraction as a decimal number, if it ends within 15 places.
pub(super) fn decimal(numerator: u128, denominator: u128) -> Option<String> {
    let whole = numerator.checked_div(denominator)?;
    let mut rest = numerator % denominator;
    let mut digits = String::new();
    while rest != 0 && digits.len() < 15 {
        rest = rest.checked_mul(10)?;
        digits.push_str(&(rest / denominator).to_string());
        rest %= denominator;
    }
    let dot = if digits.is_empty() { "" } else { "." };
    (rest == 0).then(|| format!("{whole}{dot}{digits}"))
}

/// A fraction as a decimal number if it ends, else as a fraction.
pub(super) fn fraction(numerator: u128, denominator: u128) -> String {
    decimal(numerator, denominator).unwrap_or_else(|| format!("{numerator}/{denominator}"))
}

/// A time in the largest unit that it is at least one of.
pub(super) fn duration(ns: u64) -> String {
    let units: [(u64, &str); 4] = [(1_000_000_000, "s"), (1_000_000, "ms"), (1_000, "µs"), (1, "ns")];
    let (one, symbol) = units.into_iter().find(|(one, _)| ns >= *one).unwrap_or((1_000_000, "ms"));
    format!("{}\u{A0}{symbol}", fraction(ns.into(), one.into()))
}

/// A number of bytes.
pub(super) fn bytes(count: u32) -> String {
    if count == 1 { "1\u{A0}byte".into() } else { format!("{count}\u{A0}bytes") }
}

/// A width in bits, in bytes if it is whole ones.
pub(super) fn width(bits: u32) -> String {
    match bits {
        1 => "1\u{A0}bit".into(),
        bits if bits.is_multiple_of(8) => bytes(bits / 8),
        bits => format!("{bits}\u{A0}bits"),
    }
}

/// The bytes, or the bits of a byte, that a value takes up: `0–1`, `2`, `3.0–3.2`.
pub(super) fn place(offset: u32, bits: u32) -> String {
    let end = offset + bits.max(1) - 1;
    let (first, last) = if offset.is_multiple_of(8) && bits.is_multiple_of(8) {
        ((offset / 8).to_string(), (end / 8).to_string())
    } else {
        (format!("{}.{}", offset / 8, offset % 8), format!("{}.{}", end / 8, end % 8))
    };
    if first == last { first } else { format!("{first}–{last}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_stand_in_groups() {
        assert_eq!(grouped(1000), "1000");
        assert_eq!(grouped(-123_456), "−123\u{202F}456");
    }

    #[test]
    fn fractions_are_exact() {
        assert_eq!(decimal(1, 100_000).as_deref(), Some("0.00001"));
        assert_eq!(decimal(5, 2).as_deref(), Some("2.5"));
        assert_eq!(decimal(1, 3), None);
        assert_eq!(decimal(1, 0), None);
        assert_eq!(fraction(2, 3), "2/3");
    }

    #[test]
    fn times_have_a_fitting_unit() {
        assert_eq!(duration(1_000_000), "1\u{A0}ms");
        assert_eq!(duration(62_500), "62.5\u{A0}µs");
        assert_eq!(duration(0), "0\u{A0}ms");
    }

    #[test]
    fn places_are_bytes_or_bits_of_bytes() {
        assert_eq!(place(0, 16), "0–1");
        assert_eq!(place(16, 8), "2");
        assert_eq!(place(19, 2), "2.3–2.4");
        assert_eq!(place(7, 1), "0.7");
    }
}
