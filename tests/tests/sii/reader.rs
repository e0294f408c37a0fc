//! A reader of EEPROM images that shares no code with what makes them: it knows only ETG.1000.6, slave information
//! interface. It is strict: what is not where it has to be is a panic that names it.

/// A type of category with what is in it.
pub(crate) type Category = (u16, Vec<u8>);

/// What an image says.
#[derive(Debug)]
pub(crate) struct Image {
    pub(crate) words: Vec<u16>,
    pub(crate) categories: Vec<Category>,
    pub(crate) strings: Vec<String>,
    /// The bytes up to the mark behind the last category, and it.
    pub(crate) used: usize,
}

/// A PDO.
#[derive(Debug)]
pub(crate) struct Pdo {
    pub(crate) index: u16,
    pub(crate) sync_manager: u8,
    pub(crate) name: String,
    pub(crate) flags: u16,
    pub(crate) entries: Vec<Entry>,
}

/// An entry of a PDO.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(crate) index: u16,
    pub(crate) subindex: u8,
    pub(crate) name: String,
    pub(crate) data_type: u8,
    pub(crate) bits: u8,
}

fn u16_at(bytes: &[u8], at: usize) -> u16 {
    u16::from_le_bytes([bytes[at], bytes[at + 1]])
}

/// The sum as ETG.1000.6 defines it: division by x^8 + x^2 + x + 1, a bit at a time, from 0xFF.
fn crc(bytes: &[u8]) -> u8 {
    let mut rest = 0xFF_u16;
    for byte in bytes {
        for bit in (0..8).rev() {
            let incoming = u16::from(byte >> bit & 1);
            let out = (rest >> 7 & 1) ^ incoming;
            rest = (rest << 1 & 0xFF) ^ if out == 1 { 0x07 } else { 0 };
        }
    }
    u8::try_from(rest).unwrap()
}

impl Image {
    pub(crate) fn read(bytes: &[u8]) -> Self {
        assert_eq!(u16_at(bytes, 14), u16::from(crc(&bytes[..14])), "the checksum");
        let words: Vec<u16> = (0..64).map(|word| u16_at(bytes, word * 2)).collect();
        assert_eq!(words[0x3F], 1, "the version");
        assert_eq!((usize::from(words[0x3E]) + 1) * 128, bytes.len(), "the size");
        let (mut categories, mut at): (Vec<Category>, usize) = (Vec::new(), 128);
        while u16_at(bytes, at) != 0xFFFF {
            let (kind, length) = (u16_at(bytes, at), usize::from(u16_at(bytes, at + 2)) * 2);
            assert!(categories.iter().all(|(before, _)| *before < kind), "category {kind} is not in order");
            categories.push((kind, bytes[at + 4..at + 4 + length].to_vec()));
            at += 4 + length;
        }
        assert!(bytes[at..].iter().all(|byte| *byte == 0xFF), "behind the categories");
        let mut image = Self { words, categories, strings: vec![String::new()], used: at + 2 };
        image.strings.extend(image.texts());
        image
    }

    fn texts(&self) -> Vec<String> {
        let Some(data) = self.category(10) else { return Vec::new() };
        let (mut texts, mut at) = (Vec::new(), 1);
        for _ in 0..data[0] {
            let length = usize::from(data[at]);
            texts.push(String::from_utf8(data[at + 1..at + 1 + length].to_vec()).unwrap());
            at += 1 + length;
        }
        assert!(at.next_multiple_of(2) == data.len(), "strings end where they end");
        assert!(texts.iter().all(|text| text.is_ascii() && !text.is_empty()), "{texts:?}");
        assert!(
            (1..texts.len()).all(|i| !texts[..i].contains(&texts[i])),
            "a string is there twice: {texts:?}"
        );
        texts
    }

    pub(crate) fn category(&self, kind: u16) -> Option<&[u8]> {
        self.categories.iter().find(|(it, _)| *it == kind).map(|(_, data)| data.as_slice())
    }

    pub(crate) fn string(&self, number: u8) -> &str {
        &self.strings[usize::from(number)]
    }

    pub(crate) fn long(&self, word: usize) -> u32 {
        u32::from(self.words[word]) | u32::from(self.words[word + 1]) << 16
    }

    /// The PDOs of a category, which ends where the last of them does.
    pub(crate) fn pdos(&self, kind: u16) -> Vec<Pdo> {
        let data = self.category(kind).unwrap_or_default();
        let (mut pdos, mut at) = (Vec::new(), 0);
        while at < data.len() {
            let head = &data[at..at + 8];
            let rows = data[at + 8..].chunks(8).take(head[2].into());
            let entries: Vec<Entry> = rows.map(|row| self.entry(row)).collect();
            assert_eq!(entries.len(), usize::from(head[2]), "entries of 0x{:04X}", u16_at(head, 0));
            at += 8 + 8 * entries.len();
            let name = self.string(head[5]).to_owned();
            let (index, flags) = (u16_at(head, 0), u16_at(head, 6));
            pdos.push(Pdo { index, sync_manager: head[3], name, flags, entries });
        }
        pdos
    }

    fn entry(&self, row: &[u8]) -> Entry {
        assert_eq!(row[6..], [0, 0], "flags of an entry");
        let name = self.string(row[3]).to_owned();
        Entry { index: u16_at(row, 0), subindex: row[2], name, data_type: row[4], bits: row[5] }
    }
}

/// The bytes of Intel hex: data (00), the upper half of addresses (04), the end (01).
pub(crate) fn intel_hex(text: &str) -> Vec<u8> {
    let (mut bytes, mut base, mut ended) = (Vec::new(), 0, false);
    for line in text.lines() {
        assert!(!ended, "a record behind the end");
        let digits = line.strip_prefix(':').expect("a record begins with a colon");
        let record: Vec<u8> = (0..digits.len())
            .step_by(2)
            .map(|at| u8::from_str_radix(&digits[at..at + 2], 16).unwrap())
            .collect();
        assert_eq!(record.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte)), 0, "the sum of {line}");
        let data = &record[4..record.len() - 1];
        assert_eq!(usize::from(record[0]), data.len(), "the length of {line}");
        let offset = usize::from(u16::from_be_bytes([record[1], record[2]]));
        match record[3] {
            0 => {
                assert_eq!(bytes.len(), base + offset, "the address of {line}");
                bytes.extend(data);
            }
            1 => ended = true,
            4 => base = usize::from(u16::from_be_bytes([data[0], data[1]])) << 16,
            kind => panic!("a record of type {kind}"),
        }
    }
    assert!(ended, "no end");
    bytes
}
