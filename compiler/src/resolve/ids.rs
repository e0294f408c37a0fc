//! Words that stand for things.

/// A name in kebab case: letters and digits of ASCII, everything else a dash.
pub(super) fn id(name: &str) -> String {
    let mut id = String::with_capacity(name.len());
    for c in name.chars() {
        if c.is_ascii_alphanumeric() {
            id.push(c.to_ascii_lowercase());
        } else if !id.is_empty() && !id.ends_with('-') {
            id.push('-');
        }
    }
    let id = id.trim_end_matches('-');
    if id.is_empty() { "unnamed".to_owned() } else { id.to_owned() }
}

/// An id that no sibling has yet: the id itself, or the id with the first free number.
pub(super) fn unique(name: &str, taken: &[String]) -> String {
    let id = id(name);
    if !taken.contains(&id) {
        return id;
    }
    let numbered = (2..).map(|n: u32| format!("{id}-{n}"));
    numbered.into_iter().find(|id| !taken.contains(id)).unwrap_or(id)
}
