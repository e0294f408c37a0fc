//! The process data of the JSON model, and what bytes of it mean.

use serde_json::Value as Json;

/// A family with the files that its outputs are.
pub(crate) struct Subject {
    pub(crate) id: String,
    pub(crate) members: Vec<Json>,
    pub(crate) family: devc::lint::Checked<devc::model::Family>,
}

/// What is packed as one: a PDO, or PDOs one behind the other.
pub(crate) struct Record {
    pub(crate) name: String,
    pub(crate) bits: usize,
    pub(crate) fields: Vec<Field>,
}

/// A field.
#[derive(Clone)]
pub(crate) struct Field {
    /// Its name, behind that of its PDO in an image.
    pub(crate) path: String,
    /// What is mapped: index and subindex.
    pub(crate) address: (usize, usize),
    pub(crate) offset: usize,
    pub(crate) bits: usize,
    pub(crate) data_type: String,
    /// Whether it is a word of bits, which have no sign whatever their type is called.
    pub(crate) is_word: bool,
}

/// How a field is printed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Print {
    Number,
    Real,
    Bytes,
}

/// The shipped families, and one that has what they have not.
pub(crate) fn subjects() -> Vec<Subject> {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let shipped = ["c887", "pmc-sc6", "s700"].map(|id| root.join("../devices").join(id));
    let corner = root.join("tests/consumers/corner");
    shipped.into_iter().chain([corner]).map(|folder| subject(&folder)).collect()
}

fn subject(folder: &std::path::Path) -> Subject {
    use devc::emit::{Emitter, Options, json::Json as Writer};
    let compilation = devc::compile(&devc::source::Disk, folder);
    let messages: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.as_str()).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{messages:#?}"));
    let files = Writer.emit(&family, &Options::default());
    let json: Json = serde_json::from_str(files.text(".json").unwrap()).unwrap();
    let members = json["members"].as_array().unwrap().clone();
    Subject { id: family.id.clone(), members, family }
}

pub(crate) fn text<'j>(json: &'j Json, key: &str) -> &'j str {
    json[key].as_str().unwrap_or_else(|| panic!("no {key}"))
}

pub(crate) fn number(json: &Json, key: &str) -> usize {
    usize::try_from(json[key].as_u64().unwrap_or_else(|| panic!("no {key}"))).unwrap()
}

pub(crate) fn list<'j>(json: &'j Json, key: &str) -> &'j [Json] {
    json[key].as_array().map_or(&[], Vec::as_slice)
}

/// The words that no field of the corner may be called by, with an underscore behind them.
const KEYWORDS: [&str; 4] = ["class", "int", "pack", "index"];

pub(crate) fn name(id: &str, keywords: &[&str]) -> String {
    let mut name = id.to_lowercase().replace('-', "_");
    // what a compiler of C has to tell apart
    name.truncate(63);
    let name = name.trim_end_matches('_').to_owned();
    if keywords.contains(&name.as_str()) { name + "_" } else { name }
}

/// All that a member's output has a type for; `of_language` are those of [`KEYWORDS`] that its language keeps for itself.
pub(crate) fn records(member: &Json, of_language: &[&str]) -> Vec<Record> {
    assert!(of_language.iter().all(|word| KEYWORDS.contains(word)));
    let own: Vec<Record> = list(member, "pdos").iter().map(|it| pdo(member, it, "", of_language)).collect();
    let mut records: Vec<Record> = Vec::new();
    for (role, image) in [("outputs", "outputs"), ("inputs", "inputs")] {
        let managers = list(member, "sync_managers").iter().filter(|it| text(it, "role") == role);
        let indices: Vec<usize> = managers
            .flat_map(|it| list(it, "pdos"))
            .map(|it| usize::try_from(it.as_u64().unwrap()).unwrap())
            .collect();
        records.extend(joined(image.to_owned(), &indices, &own));
    }
    for configuration in list(member, "configurations") {
        let id = name(text(configuration, "id"), &[]);
        let mapped: Vec<Record> = list(configuration, "mapping")
            .iter()
            .map(|it| pdo(member, it, &format!("{id}_"), of_language))
            .collect();
        for key in ["outputs", "inputs"] {
            let Some(indices) = configuration[key].as_array() else { continue };
            let indices: Vec<usize> =
                indices.iter().map(|it| usize::try_from(it.as_u64().unwrap()).unwrap()).collect();
            let known: Vec<&Record> = mapped.iter().chain(&own).collect();
            records.extend(joined(format!("{id}_{key}"), &indices, &known));
        }
        records.extend(mapped);
    }
    own.into_iter().chain(records).collect()
}

fn pdo(member: &Json, pdo: &Json, prefix: &str, keywords: &[&str]) -> Record {
    let way = text(pdo, "direction");
    let fields = list(pdo, "entries").iter().filter(|entry| !entry["address"].is_null()).map(|entry| Field {
        path: name(text(entry, "id"), keywords),
        address: (number(&entry["address"], "index"), number(&entry["address"], "subindex")),
        offset: number(entry, "offset"),
        bits: number(entry, "bits"),
        data_type: entry["data_type"].as_str().unwrap_or_default().to_owned(),
        is_word: is_word(member, &entry["address"]),
    });
    let bits = list(pdo, "entries").iter().map(|entry| number(entry, "bits")).sum();
    Record { name: format!("{prefix}{way}_{:04x}", number(pdo, "index")), bits, fields: fields.collect() }
}

fn is_word(member: &Json, address: &Json) -> bool {
    word(member, address).is_some()
}

/// The word at an address; it stands once for all axes.
pub(crate) fn word<'j>(member: &'j Json, address: &Json) -> Option<&'j Json> {
    let object = list(member, "objects").iter().find(|object| object["index"] == address["index"]);
    let leading = object.map_or(&address["index"], |object| &object["leading"]);
    let same = |word: &&Json| {
        word["address"]["index"] == *leading && word["address"]["subindex"] == address["subindex"]
    };
    list(member, "words").iter().find(same)
}

/// PDOs one behind the other, bit by bit; none if there are none.
fn joined(name: String, indices: &[usize], known: &[impl std::borrow::Borrow<Record>]) -> Option<Record> {
    let (mut bits, mut fields) = (0, Vec::new());
    for index in indices {
        let end = format!("_{index:04x}");
        let pdo = known.iter().map(|it| it.borrow()).find(|it| it.name.ends_with(&end)).unwrap();
        let short = &pdo.name[pdo.name.len() - 7..];
        fields.extend(pdo.fields.iter().map(|field| Field {
            path: format!("{short}.{}", field.path),
            offset: bits + field.offset,
            ..field.clone()
        }));
        bits += pdo.bits;
    }
    (!indices.is_empty()).then_some(Record { name, bits, fields })
}

impl Record {
    pub(crate) fn bytes(&self) -> usize {
        self.bits.div_ceil(8)
    }

    /// Bytes to unpack: none set, all set, and some that follow a rule. Numbers with a fraction are numbers.
    pub(crate) fn samples(&self) -> Vec<Vec<u8>> {
        let mut state = 0x2545_F491_u32 ^ u32::try_from(self.bits).unwrap();
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        let bytes = self.bytes();
        let mut samples = vec![vec![0; bytes], vec![0xFF; bytes]];
        samples.extend((0..8).map(|_| (0..bytes).map(|_| random()).collect::<Vec<u8>>()));
        for sample in &mut samples {
            for field in self.fields.iter().filter(|field| field.print() == Print::Real) {
                set(sample, field.offset + field.bits - 2, false);
            }
        }
        samples
    }

    /// What comes back when the values of some bytes are packed.
    pub(crate) fn repacked(&self, sample: &[u8]) -> Vec<u8> {
        let mut bytes = vec![0; self.bytes()];
        for field in &self.fields {
            let value = field.raw(sample);
            (0..field.bits).for_each(|bit| set(&mut bytes, field.offset + bit, value[bit]));
        }
        bytes
    }
}

fn get(bytes: &[u8], bit: usize) -> bool {
    (bytes[bit / 8] >> (bit % 8)) & 1 == 1
}

pub(crate) fn set(bytes: &mut [u8], bit: usize, value: bool) {
    let mask = 1 << (bit % 8);
    let others = bytes[bit / 8] & !mask;
    bytes[bit / 8] = if value { others | mask } else { others };
}

impl Field {
    pub(crate) fn print(&self) -> Print {
        let bytes = ["STRING", "OCTET", "UNICODE"].iter().any(|kind| self.data_type.starts_with(kind));
        match self.data_type.as_str() {
            _ if bytes => Print::Bytes,
            "REAL32" if self.bits == 32 => Print::Real,
            "REAL64" if self.bits == 64 => Print::Real,
            _ if self.bits > 64 => Print::Bytes,
            _ => Print::Number,
        }
    }

    /// The bits of its value, at least as many as are mapped: those of its type, and copies of the sign or zeros above.
    fn raw(&self, sample: &[u8]) -> Vec<bool> {
        let mut bits: Vec<bool> = (0..self.bits).map(|bit| get(sample, self.offset + bit)).collect();
        let width = self.data_type.trim_start_matches(char::is_alphabetic).parse::<usize>();
        let signed = self.data_type.starts_with("INT") && !self.is_word;
        if let (Ok(width), Print::Number) = (width, self.print()) {
            let filling = signed && bits[self.bits - 1];
            bits.resize(width, filling);
        }
        if self.print() == Print::Number {
            let filling = signed && bits[bits.len() - 1];
            bits.resize(64, filling);
        }
        bits
    }

    /// As it is printed: a number as 64 bits with its sign, all else as it lies in memory.
    pub(crate) fn printed(&self, sample: &[u8]) -> String {
        let bits = self.raw(sample);
        let byte = |bits: &[bool]| bits.iter().enumerate().map(|(at, bit)| u8::from(*bit) << at).sum::<u8>();
        bits.chunks(8).map(|bits| format!("{:02x}", byte(bits))).collect()
    }
}
