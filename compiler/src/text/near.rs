//! Names that look alike, for "did you mean".

/// The name that is most like `wrong`, if one is like it at all.
pub(crate) fn near<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    alike(wrong, names).min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
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
    names
        .filter(|name| !name.is_empty())
        .map(move |name| (strsim::damerau_levenshtein(&wrong, &name.to_lowercase()), name))
        .filter(|(distance, name)| *distance <= name.chars().count().max(3) / 3)
}

/// Names in a sentence: `` `a`, `b` and `c` ``.
pub(crate) fn list(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.as_slice() {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::meant;

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
