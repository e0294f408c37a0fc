//! Another name for an axis: in the list of axes, in the lists of modules, and as a key under `per-axis`, alone or in a
//! range.

use super::edit::{Refusal, Renaming, inner};
use super::spot::{Spot, all};

/// The axis that a spot names, as it is written there; of a range the first.
pub(super) fn named(spot: &Spot) -> Option<&str> {
    let path = spot.plain();
    let written = match (&spot.text, path.as_slice()) {
        (Some(text), ["axes", "names"] | ["modules", _, "axes"]) => Some(text.as_str()),
        (None, [.., "per-axis", name]) => Some(*name),
        _ => None,
    };
    Some(written?.split("..=").next()?.trim()).filter(|name| !name.is_empty())
}

/// The edits of each file.
///
/// # Errors
/// If the new name is none for an axis.
pub(super) fn rename(old: &str, new: &str, files: &[&str]) -> Result<Vec<Renaming>, Refusal> {
    let is_odd = |c: char| c.is_control() || matches!(c, '"' | '\'' | '\\');
    if new.trim().is_empty() || new.contains("..=") || new.contains(is_odd) {
        return Err(Refusal(format!(
            "`{new}` is no name of an axis: it is neither empty nor a range, and needs no escapes"
        )));
    }
    let is_taken = files.iter().any(|text| names(text).iter().any(|name| name == new));
    if is_taken {
        return Err(Refusal(format!("`{new}` is another axis")));
    }
    Ok(files.iter().map(|text| edits(text, old, new)).collect())
}

/// The names of the axes that a text lists.
fn names(text: &str) -> Vec<String> {
    let mut names = Vec::new();
    all(text, &mut |spot| {
        if spot.text.is_some() && spot.plain() == ["axes", "names"] {
            names.extend(spot.text);
        }
    });
    names
}

fn edits(text: &str, old: &str, new: &str) -> Renaming {
    let mut edits = Vec::new();
    all(text, &mut |spot| {
        let path = spot.plain();
        let of_key = spot.text.is_none().then(|| path.last().copied()).flatten();
        let is_about = named(&spot).is_some()
            && spot
                .text
                .as_deref()
                .or(of_key)
                .is_some_and(|name| name.split("..=").any(|end| end.trim() == old));
        let Some(at) = inner(&spot, text, old).filter(|_| is_about) else { return };
        let is_bare = |name: &str| name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'));
        let is_quoted = text.get(spot.at.clone()).is_some_and(|it| it.starts_with(['"', '\'']));
        let written = if is_quoted || is_bare(new) { new.to_owned() } else { format!("\"{new}\"") };
        edits.push((at, written));
    });
    edits
}
