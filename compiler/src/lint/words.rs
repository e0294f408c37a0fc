//! The words of names, and slips of the pen in them.

use std::collections::BTreeMap;

/// A word is told from another by one letter only if it is this long: `opmode` and `opemode`, but not `mode` and `node`.
const TOLD_APART: usize = 6;

/// A longer word is no word, and would cost as many look-ups as it has letters.
const LONGEST: usize = 40;

/// Words that one letter tells from another word.
const BOTH_WORDS: &[(&str, &str)] =
    &[("present", "preset"), ("through", "though"), ("started", "stated"), ("contract", "contact")];

/// The words of a name in lower case.
pub(super) fn words(name: &str) -> Vec<String> {
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect()
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

/// The words of a device's names, with how often each is used.
#[derive(Default)]
pub(super) struct Vocabulary {
    uses: BTreeMap<String, usize>,
    /// Words by those that are slips of them.
    slips: BTreeMap<String, String>,
    /// How often a word stands before a number, with the number once.
    numbered: BTreeMap<String, (usize, String)>,
}

impl Vocabulary {
    /// The words of these names.
    pub(super) fn of<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        let mut all = Self::default();
        for words in names.map(words) {
            for (word, number) in words.iter().zip(words.iter().skip(1)) {
                if number.chars().all(|c| c.is_ascii_digit()) {
                    all.numbered.entry(word.clone()).or_insert((0, number.clone())).0 += 1;
                }
            }
            for word in words.into_iter().filter(|word| word.len() <= LONGEST) {
                *all.uses.entry(word).or_default() += 1;
            }
        }
        all.slips = all.slips();
        all
    }

    /// The words that are slips of others: of two that a letter more or the order of two letters tells apart, the one that
    /// is used less. A letter that is another one most often makes another word.
    fn slips(&self) -> BTreeMap<String, String> {
        let mut slips: BTreeMap<String, String> = BTreeMap::new();
        for (word, uses) in self.uses.iter().filter(|(word, _)| word.chars().count() >= TOLD_APART) {
            let shorter = without_one(word).filter(|short| short.chars().count() >= TOLD_APART);
            for (other, others) in
                shorter.chain(transposed(word)).filter_map(|it| self.uses.get_key_value(&it))
            {
                let (slip, meant) = if uses < others { (word, other) } else { (other, word) };
                let is_better = |known: &String| self.uses(known) < self.uses(meant);
                if uses != others
                    && is_slip(slip, meant)
                    && !BOTH_WORDS.contains(&(word.min(other).as_str(), word.max(other).as_str()))
                    && slips.get(slip).is_none_or(is_better)
                {
                    slips.insert(slip.clone(), meant.clone());
                }
            }
        }
        slips
    }

    /// The word that is meant by another, if it is used more often, and how often it is.
    pub(super) fn meant(&self, word: &str) -> Option<(&str, usize)> {
        self.slips.get(word).map(|meant| (meant.as_str(), self.uses(meant)))
    }

    /// What a word with a number at its end is elsewhere, if it is so more often: the word, then a number.
    pub(super) fn parted(&self, word: &str) -> Option<String> {
        let alone = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let (uses, number) = self.numbered.get(alone).filter(|_| alone.len() < word.len())?;
        let joined = self.uses.range(alone.to_owned()..).take_while(|(other, _)| other.starts_with(alone));
        let is_numbered = |other: &str| {
            let rest = other.strip_prefix(alone).unwrap_or_default();
            !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit())
        };
        let joined: usize = joined.filter(|(other, _)| is_numbered(other)).map(|(_, uses)| uses).sum();
        (*uses > joined && alone.chars().count() >= TOLD_APART).then(|| format!("{alone} {number}"))
    }

    fn uses(&self, word: &str) -> usize {
        self.uses.get(word).copied().unwrap_or_default()
    }
}

/// A word without each of its letters in turn.
fn without_one(word: &str) -> impl Iterator<Item = String> {
    word.char_indices().map(|(at, letter)| {
        let (before, rest) = word.split_at(at);
        [before, rest.split_at(letter.len_utf8()).1].concat()
    })
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
    use super::{Vocabulary, is_slip};

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
        assert_eq!(words.meant("postion"), Some(("position", 3)));
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
        assert_eq!(words.parted("manager3").as_deref(), Some("manager 0"));
        assert_eq!(words.parted("output1"), None, "most are written so");
        assert_eq!(words.parted("manager"), None);
    }
}
