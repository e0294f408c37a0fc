//! What differs between two parts of the model, and where.

use std::borrow::Cow;
use std::fmt;

use crate::source::{Location, Origin};

/// A way from a part of the model down to a value: `objects`, `0x6040`, `entries`, `0`, `default`.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct FieldPath(pub Vec<PathStep>);

/// A field, or what tells an item of a list from its siblings.
pub type PathStep = Cow<'static, str>;

/// What differs at a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Where.
    pub path: FieldPath,
    /// The value in the first of the two; none if it lacks what stands there.
    pub first: Option<String>,
    /// The value in the second.
    pub second: Option<String>,
    /// Whether it is the order of a list in which they differ; the values are what tells its items apart.
    pub is_order: bool,
    /// Where the first has it from.
    pub first_at: Option<Location>,
    /// Where the second has it from.
    pub second_at: Option<Location>,
}

impl FieldPath {
    /// Does something one step further down.
    pub(crate) fn within(&mut self, step: impl Into<PathStep>, act: impl FnOnce(&mut Self)) {
        self.0.push(step.into());
        act(self);
        self.0.pop();
    }

    pub(super) fn differ(&self, first: Option<String>, second: Option<String>) -> Difference {
        Difference { path: self.clone(), first, second, is_order: false, first_at: None, second_at: None }
    }
}

impl Difference {
    /// Says where the two were written, by the origins of the parts in which they differ, `depth` steps down the path;
    /// what is known already was found further inside, and is nearer.
    pub(crate) fn written(mut self, depth: usize, first: Option<&Origin>, second: Option<&Origin>) -> Self {
        let steps = self.path.0.get(depth..).unwrap_or_default();
        self.first_at = self.first_at.or_else(|| first.map(|origin| origin.located(steps, None)));
        self.second_at = self.second_at.or_else(|| second.map(|origin| origin.located(steps, None)));
        self
    }
}

impl Origin {
    /// Where the value of a field was written, or an item of it, as near as the description says it.
    pub(crate) fn located(&self, steps: &[PathStep], item: Option<usize>) -> Location {
        let keys = steps.iter().map(|step| key(step)).chain(item.map(|item| item.to_string()));
        let keys: Vec<String> = keys.collect();
        let known = (1..=keys.len()).rev().filter_map(|length| keys.get(..length)).map(|keys| keys.join("."));
        known.filter(|path| self.has(path)).map(|path| self.value(&path)).next().unwrap_or(self.header())
    }
}

/// The key of a field in a description.
fn key(field: &str) -> String {
    match field {
        "data_type" => "type".to_owned(),
        "fields" => "bits".to_owned(),
        field => field.replace('_', "-"),
    }
}

impl fmt::Display for FieldPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join("."))
    }
}
