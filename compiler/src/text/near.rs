//! Names that look alike, for "did you mean".

/// The name that is most like `wrong`, if one is like it at all.
pub(crate) fn near<'n>(wrong: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    alike(wrong, names).min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
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
