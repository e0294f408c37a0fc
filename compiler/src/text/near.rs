//! Names that look alike, for "did you mean".

/// How many names a sentence lists.
const LISTED: usize = 60;

/// How many pairs of letters are compared for one suggestion; among names as many and as similar, the nearest of the
/// first is near enough.
const WORK: usize = 1 << 19;

/// The name that is most like `wrong`, if one is like it at all.
pub(crate) fn near<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    alike(wrong, names).min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
}

/// The name that differs from `wrong` by one letter, or by two in the other order.
pub(crate) fn nearly<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    alike(wrong, names).find(|(distance, _)| *distance <= 1).map(|(_, name)| name)
}

/// The name that is most like `wrong`, and whether it is plain that it was meant: only upper and lower case differ, or one
/// letter of a long word, and no other name is as like. A word of few letters or another number is another word.
pub(crate) fn meant<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Option<(&'n str, bool)> {
    let mut alike: Vec<(usize, &str)> = alike(wrong, names).collect();
    alike.sort_by_key(|(distance, _)| *distance);
    let (distance, name) = *alike.first()?;
    let digits = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
    let is_alone = alike.get(1).is_none_or(|(other, _)| *other > distance.max(1));
    let is_slip =
        distance == 0 || distance == 1 && name.chars().count() >= 6 && digits(wrong) == digits(name);
    Some((name, is_slip && is_alone))
}

/// The names that are like `wrong`, the most alike first.
#[cfg(feature = "cli")]
pub(crate) fn nearest<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Vec<&'n str> {
    let mut alike: Vec<(usize, &str)> = alike(wrong, names).collect();
    alike.sort_by_key(|(distance, _)| *distance);
    alike.into_iter().map(|(_, name)| name).collect()
}

/// The names that are like `wrong`, each with how many letters are between them.
fn alike<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> impl Iterator<Item = (usize, &'n str)> {
    let wrong = wrong.to_lowercase();
    let mut work = WORK;
    names.filter(|name| !name.is_empty()).filter_map(move |name| {
        let most = name.chars().count().max(3) / 3;
        if lacking(&wrong, name) > most {
            return None;
        }
        let lower = name.to_lowercase();
        work = work.checked_sub(wrong.len().saturating_mul(lower.len()))?;
        let distance = strsim::damerau_levenshtein(&wrong, &lower);
        (distance <= most).then_some((distance, name))
    })
}

/// How many letters one word has that the other lacks, small and capital ones alike, or less: at least as many are between
/// them. It is counted in an instant, and most names are told apart by it.
fn lacking(one: &str, other: &str) -> usize {
    let mut counts = [0_isize; 64];
    let mut count = |word: &str, by| {
        for letter in word.chars().flat_map(char::to_lowercase) {
            // letters that share a place only make the sum smaller
            let place = usize::try_from(u32::from(letter) % 64).ok();
            place.and_then(|place| counts.get_mut(place)).into_iter().for_each(|count| *count += by);
        }
    };
    count(one, 1);
    count(other, -1);
    let sum = |sign: isize| counts.iter().map(|count| (count * sign).max(0).unsigned_abs()).sum::<usize>();
    sum(1).max(sum(-1))
}

/// Names in a sentence: `` `a`, `b` and `c` ``, the first of them if they are many.
pub(crate) fn list(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().take(LISTED).map(|name| format!("`{name}`")).collect();
    let rest = names.len().saturating_sub(LISTED);
    match quoted.as_slice() {
        [] => "none".to_owned(),
        all if rest > 0 => format!("{} and {rest} more", all.join(", ")),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_is_near() {
        let names = ["controlword", "statusword", "target-position", "csp"];
        let nearest = |wrong| near(wrong, names.into_iter());
        assert_eq!(nearest("ControlWord"), Some("controlword"));
        assert_eq!(nearest("contorlword"), Some("controlword"));
        assert_eq!(nearest("statsword"), Some("statusword"));
        assert_eq!(nearest("target-positionn"), Some("target-position"));
        assert_eq!(nearest("cps"), Some("csp"));
        assert_eq!(nearest("velocity"), None);
        assert_eq!(nearest(""), None);
    }

    #[test]
    fn of_several_the_nearest_and_of_equals_the_first() {
        assert_eq!(near("unit", ["units", "united", "unit"].into_iter()), Some("unit"));
        assert_eq!(near("gauge-0", ["gauge-1", "gauge-2"].into_iter()), Some("gauge-1"));
    }

    #[test]
    fn letters_that_are_lacking_are_no_more_than_those_between() {
        let words = ["", "csp", "cps", "unit", "tinu", "größe", "grösse", "速度", "target-position"];
        for (one, other) in words.iter().flat_map(|one| words.iter().map(move |other| (one, other))) {
            assert!(lacking(one, other) <= strsim::damerau_levenshtein(one, other), "{one} and {other}");
        }
        assert_eq!(lacking("unit", "xyz"), 4);
    }

    #[test]
    fn a_list_is_a_sentence_however_long() {
        assert_eq!(list(&[]), "none");
        assert_eq!(list(&["a"]), "`a`");
        assert_eq!(list(&["a", "b", "c"]), "`a`, `b` and `c`");
        assert!(list(&["x"; 100]).ends_with("`x`, `x` and 40 more"));
    }

    #[test]
    fn a_slip_is_plain_and_another_word_is_not() {
        let names = ["controlword", "statusword", "digital-inputs", "digital-outputs", "value-1", "rpm"];
        let meant = |wrong| meant(wrong, names.into_iter());
        for (wrong, name) in [("contrlword", "controlword"), ("Statusword", "statusword"), ("stauts", "")] {
            let found = meant(wrong);
            assert_eq!(found, (!name.is_empty()).then_some((name, true)), "{wrong}");
        }
        // two letters, another number, a short word
        assert_eq!(meant("cntrlword"), Some(("controlword", false)));
        assert_eq!(meant("value-2"), Some(("value-1", false)));
        assert_eq!(meant("rps"), Some(("rpm", false)));
    }
}
