//! The words of names, and slips of the pen in them.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Bound;

/// A word is told from another by one letter only if it is this long: `opmode` and `opemode`, but not `mode` and `node`.
const TOLD_APART: usize = 6;

/// A longer word is no word, and would cost as many look-ups as it has letters.
const LONGEST: usize = 40;

/// Words that one letter tells from another word.
const BOTH_WORDS: &[(&str, &str)] =
    &[("present", "preset"), ("through", "though"), ("started", "stated"), ("contract", "contact")];

/// The words of a name in lower case.
pub(super) fn words(name: &str) -> Vec<Cow<'_, str>> {
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(lower).collect()
}

fn lower(word: &str) -> Cow<'_, str> {
    let is_lower = word.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit());
    if is_lower { Cow::Borrowed(word) } else { Cow::Owned(word.to_lowercase()) }
}

/// Whether a word is another with one letter changed, missing, too many, or in the other's place. Endings are grammar
/// (`speed`, `speeds`), and there are two ways to spell English.
pub(super) fn is_slip(word: &str, meant: &str) -> bool {
    let least = word.chars().count().min(meant.chars().count());
    word.chars().next() == meant.chars().next()
        && !(word.starts_with(meant) || meant.starts_with(word))
        && !word.chars().chain(meant.chars()).any(char::is_numeric)
        && least >= if is_transposed(word, meant) { 4 } else { 5 }
        && spelt(word) != spelt(meant)
        && strsim::damerau_levenshtein(word, meant) == 1
}

/// Whether the words have the same letters.
fn is_transposed(word: &str, other: &str) -> bool {
    let sorted = |word: &str| {
        let mut letters: Vec<char> = word.chars().collect();
        letters.sort_unstable();
        letters
    };
    sorted(word) == sorted(other)
}

/// A word in one of the spellings that English has for it.
fn spelt(word: &str) -> String {
    let one =
        [("our", "or"), ("tre", "ter"), ("lling", "ling"), ("lled", "led"), ("ae", "e"), ("ence", "ense")];
    one.iter().fold(word.replace('z', "s"), |word, (british, american)| word.replace(british, american))
}

/// The words of a device's names that others of them have otherwise, with what is meant.
pub(super) struct Vocabulary {
    odd: BTreeMap<String, Meant>,
}

/// What is meant by a word.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Meant {
    /// A word that is used so often.
    Word(String, usize),
    /// The word, and then its number.
    Parted(String),
}

impl Vocabulary {
    /// The words of these names.
    pub(super) fn of<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        let uses = Uses::of(names);
        let parted = uses.of_word.keys().filter_map(|word| Some((word.to_string(), uses.parted(word)?)));
        let parted = parted.map(|(word, meant)| (word, Meant::Parted(meant)));
        let slips = uses.slips().into_iter();
        let slips =
            slips.map(|(slip, meant)| (slip.to_owned(), Meant::Word(meant.to_owned(), uses.count(meant))));
        Self { odd: parted.chain(slips).collect() }
    }

    /// Whether no word is odd.
    pub(super) fn is_regular(&self) -> bool {
        self.odd.is_empty()
    }

    /// What is meant by a word that most names have otherwise.
    pub(super) fn meant(&self, word: &str) -> Option<&Meant> {
        self.odd.get(word)
    }
}

/// How often each word is used.
#[derive(Default)]
struct Uses<'n> {
    of_word: BTreeMap<Cow<'n, str>, usize>,
    /// How often a word stands before a number, with the number once.
    numbered: BTreeMap<Cow<'n, str>, (usize, Cow<'n, str>)>,
}

impl<'n> Uses<'n> {
    fn of(names: impl Iterator<Item = &'n str>) -> Self {
        let mut all = Self::default();
        for words in names.map(words) {
            for (word, number) in words.iter().zip(words.iter().skip(1)) {
                if number.chars().all(|c| c.is_ascii_digit()) {
                    all.numbered.entry(word.clone()).or_insert((0, number.clone())).0 += 1;
                }
            }
            for word in words.into_iter().filter(|word| word.len() <= LONGEST) {
                *all.of_word.entry(word).or_default() += 1;
            }
        }
        all
    }

    /// The words that are slips of others, with these: of two that a letter more or the order of two letters tells apart, the
    /// one that is used less. A letter that is another one most often makes another word.
    fn slips(&self) -> BTreeMap<&str, &str> {
        let mut slips: BTreeMap<&str, &str> = BTreeMap::new();
        let weights = self.weights();
        for (word, uses) in self.of_word.iter().filter(|(word, _)| word.chars().count() >= TOLD_APART) {
            let shorter = without_one(word, |weight| weights.contains_key(&weight));
            let shorter = shorter.filter(|short| short.chars().count() >= TOLD_APART);
            let has_double = weights.get(&weight(word)).is_some_and(|words| *words > 1);
            let transposed = has_double.then(|| transposed(word)).into_iter().flatten();
            for (other, others) in
                shorter.chain(transposed).filter_map(|it| self.of_word.get_key_value(it.as_str()))
            {
                let (word, other): (&str, &str) = (word, other);
                let (slip, meant) = if uses < others { (word, other) } else { (other, word) };
                let is_better = |known: &&str| self.count(known) < self.count(meant);
                if uses != others
                    && is_slip(slip, meant)
                    && !BOTH_WORDS.contains(&(word.min(other), word.max(other)))
                    && slips.get(slip).is_none_or(is_better)
                {
                    slips.insert(slip, meant);
                }
            }
        }
        slips
    }

    /// How many words have each weight.
    fn weights(&self) -> BTreeMap<u32, usize> {
        let mut weights = BTreeMap::new();
        for word in self.of_word.keys() {
            *weights.entry(weight(word)).or_default() += 1;
        }
        weights
    }

    /// What a word with a number at its end is elsewhere, if it is so more often: the word, then a number.
    fn parted(&self, word: &str) -> Option<String> {
        let alone = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let (uses, number) = self.numbered.get(alone).filter(|_| alone.len() < word.len())?;
        let from = (Bound::Included(alone), Bound::Unbounded);
        let joined = self.of_word.range::<str, _>(from).take_while(|(other, _)| other.starts_with(alone));
        let is_numbered = |other: &str| {
            let rest = other.strip_prefix(alone).unwrap_or_default();
            !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit())
        };
        let joined: usize = joined.filter(|(other, _)| is_numbered(other)).map(|(_, uses)| uses).sum();
        (*uses > joined && alone.chars().count() >= TOLD_APART).then(|| format!("{alone} {number}"))
    }

    fn count(&self, word: &str) -> usize {
        self.of_word.get(word).copied().unwrap_or_default()
    }
}

/// What words with the same letters share, in whatever order: most words of which there is none need not be spelt.
fn weight(word: &str) -> u32 {
    word.bytes().map(|byte| u32::from(byte).pow(2)).sum()
}

/// A word without each of its letters in turn, if there may be a word of that weight.
fn without_one(word: &str, is_there: impl Fn(u32) -> bool) -> impl Iterator<Item = String> {
    let whole = weight(word);
    let letters = word.char_indices().map(|(at, letter)| (at, at + letter.len_utf8()));
    let parts = letters.filter_map(|(at, end)| Some((word.get(..at)?, word.get(at..end)?, word.get(end..)?)));
    let parts = parts.filter(move |(_, letter, _)| is_there(whole - weight(letter)));
    parts.map(|(before, _, rest)| [before, rest].concat())
}

/// A word with each two neighbours in the other order.
fn transposed(word: &str) -> impl Iterator<Item = String> {
    word.char_indices().zip(word.chars().skip(1)).map(|((at, first), second)| {
        let (before, rest) = word.split_at(at);
        let (first, rest) = rest.split_at(first.len_utf8());
        let (second, rest) = rest.split_at(second.len_utf8());
        [before, second, first, rest].concat()
    })
}

#[cfg(test)]
mod tests {
    use super::{Meant, Vocabulary, is_slip};

    #[test]
    fn a_slip_is_one_letter_and_no_other_word() {
        for (word, meant) in [("idendity", "identity"), ("egde", "edge"), ("sychronize", "synchronize")] {
            assert!(is_slip(word, meant), "{word}");
        }
        for (word, other) in [
            ("types", "type"),
            ("organisation", "organization"),
            ("catalog", "catalogue"),
            ("centre", "center"),
            ("behaviour", "behavior"),
            ("mode", "node"),
            ("power", "lower"),
            ("input1", "input2"),
            ("acceleration", "deceleration"),
        ] {
            assert!(!is_slip(word, other), "{word} and {other}");
        }
    }

    #[test]
    fn what_is_used_more_often_is_meant() {
        let names =
            ["Position", "Position limit", "Postion reached", "Present position", "Preset value", "Preset"];
        let words = Vocabulary::of(names.into_iter());
        assert_eq!(words.meant("postion"), Some(&Meant::Word("position".to_owned(), 3)));
        assert_eq!(words.meant("position"), None, "it is the usual one");
        assert_eq!(words.meant("present"), None, "both are words");
        let words = Vocabulary::of(
            ["Power stage", "State", "State of charge", "Shaft", "Shift", "Shift 2"].into_iter(),
        );
        assert_eq!(words.meant("stage"), None);
        assert_eq!(words.meant("shaft"), None);
    }

    #[test]
    fn numbers_are_parted_from_words_as_elsewhere() {
        let words = Vocabulary::of(
            ["Manager 0", "Manager 1", "Manager3", "Output1", "Output2", "Output 3"].into_iter(),
        );
        assert_eq!(words.meant("manager3"), Some(&Meant::Parted("manager 0".to_owned())));
        assert_eq!(words.meant("output1"), None, "most are written so");
        assert_eq!(words.meant("manager"), None);
    }
}
