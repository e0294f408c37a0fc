//! Texts that are made while code is compiled: messages of constants that must not be.

/// A text of at most 160 bytes; what is beyond is cut off.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Text {
    bytes: [u8; 160],
    length: usize,
}

impl Text {
    pub(crate) const fn new() -> Self {
        Self { bytes: [0; 160], length: 0 }
    }

    /// The text with another behind it.
    pub(crate) const fn text(mut self, text: &str) -> Self {
        let mut rest = text.as_bytes();
        while let Some((byte, others)) = rest.split_first() {
            self = self.byte(*byte);
            rest = others;
        }
        self
    }

    /// The text with a number behind it.
    pub(crate) const fn number(self, number: usize) -> Self {
        let digit = b'0' + (number % 10) as u8;
        let before = if number >= 10 { self.number(number / 10) } else { self };
        before.byte(digit)
    }

    /// The text with an index behind it, as `0x1600`.
    pub(crate) const fn hex(self, index: u16) -> Self {
        let text = self.text("0x");
        text.digit(index >> 12).digit(index >> 8).digit(index >> 4).digit(index)
    }

    /// The text with indices behind it.
    pub(crate) const fn list(mut self, mut indices: &[u16]) -> Self {
        let mut between = "";
        while let Some((index, rest)) = indices.split_first() {
            self = self.text(between).hex(*index);
            (indices, between) = (rest, ", ");
        }
        self
    }

    pub(crate) const fn as_str(&self) -> &str {
        let (text, _) = self.bytes.split_at(self.length);
        match core::str::from_utf8(text) {
            Ok(text) => text,
            Err(_) => "",
        }
    }

    const fn digit(self, number: u16) -> Self {
        let digit = (number & 0xF) as u8;
        self.byte(if digit < 10 { b'0' + digit } else { b'A' + digit - 10 })
    }

    const fn byte(mut self, byte: u8) -> Self {
        if let Some((_, rest)) = self.bytes.split_at_mut_checked(self.length)
            && let Some(place) = rest.first_mut()
        {
            *place = byte;
            self.length += 1;
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::Text;

    #[test]
    fn texts_are_put_together() {
        let text = Text::new().hex(0x1A0F).text(" has ").number(1020).text(" of ").list(&[1, 0xABCD]);
        assert_eq!(text.as_str(), "0x1A0F has 1020 of 0x0001, 0xABCD");
    }

    #[test]
    fn what_does_not_fit_is_cut_off() {
        let text = (0..100).fold(Text::new(), |text, _| text.text("ab"));
        assert_eq!(text.as_str(), "ab".repeat(80));
    }
}
