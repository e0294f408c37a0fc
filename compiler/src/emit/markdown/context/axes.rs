//! What is written once for all axes: the first axis stands for the others.

use super::Context;
use crate::emit::markdown::holds::{Form, Holds};
use crate::emit::markdown::inline::text;
use crate::emit::markdown::table::Title;
use crate::model::{Axis, Index, Object, Pdo, Repeated};

impl<'a> Context<'a> {
    /// Whether there is more than one axis.
    pub(in crate::emit::markdown) fn has_axes(&self) -> bool {
        self.device.axes.len() > 1
    }

    /// Axes in running text: `all axes`, `axis X`, `axes Y to W`.
    pub(in crate::emit::markdown) fn axes(&self, numbers: &[u8]) -> String {
        match numbers {
            _ if numbers.len() == self.device.axes.len() => "all axes".into(),
            [_] => format!("axis {}", self.axis_range(numbers)),
            _ => format!("axes {}", self.axis_range(numbers)),
        }
    }

    /// A text that holds on some axes only.
    pub(in crate::emit::markdown) fn for_axes(&self, numbers: &[u8], text: String) -> String {
        match self.form {
            Form::Text => text,
            Form::Page => Holds::on_axes(numbers).around("", &text),
        }
    }

    /// The names of the axes.
    pub(in crate::emit::markdown) fn axis_names(&self) -> impl Iterator<Item = &'a str> {
        self.device.axes.iter().map(|axis| axis.name.as_str())
    }

    /// The title of a column for each axis.
    pub(in crate::emit::markdown) fn axis_titles(&self, word: &str) -> impl Iterator<Item = Title> {
        let title = move |axis: &Axis| Title {
            text: format!("{word} {}", text(&axis.name)),
            holds: Holds::on_axes(&[axis.number]),
        };
        self.device.axes.iter().map(title)
    }

    /// Axes by name: `X`, `Y to W`, `X, Z`.
    pub(in crate::emit::markdown) fn axis_range(&self, numbers: &[u8]) -> String {
        let name =
            |number: &u8| text(self.device.axes.get(usize::from(*number)).map_or("?", |axis| &axis.name));
        let row = numbers
            .iter()
            .zip(numbers.iter().skip(1))
            .all(|(one, next)| u16::from(*one) + 1 == u16::from(*next));
        match numbers {
            [first, .., last] if row && numbers.len() > 2 => format!("{} to {}", name(first), name(last)),
            _ => numbers.iter().map(name).collect::<Vec<_>>().join(", "),
        }
    }

    /// The objects to print: those of the whole device, and one for all axes.
    pub(in crate::emit::markdown) fn leading_objects(&self) -> impl Iterator<Item = &'a Object> {
        self.device.objects.iter().filter(|object| object.is_leading())
    }

    /// The object as it is on each axis.
    pub(in crate::emit::markdown) fn on_axes(&self, object: &Object) -> Vec<Option<&'a Object>> {
        let on = |index: Option<Index>| index.and_then(|index| self.device.object(index));
        self.indices(object.leading).map(on).collect()
    }

    /// The PDOs to print: those of the whole device, and one for all axes.
    pub(in crate::emit::markdown) fn leading_pdos(&self) -> impl Iterator<Item = &'a Pdo> {
        self.device.pdos.iter().filter(|pdo| pdo.is_leading())
    }

    /// The PDO as it is on each axis.
    pub(in crate::emit::markdown) fn pdo_on_axes(&self, leading: &Pdo) -> Vec<Option<&'a Pdo>> {
        let on = |index: Option<Index>| index.and_then(|index| self.device.pdo(index));
        self.indices(leading.leading).map(on).collect()
    }

    /// The index on each axis of what was written for all of them; nowhere if it is there once.
    fn indices(&self, leading: Index) -> impl Iterator<Item = Option<Index>> + use<'a> {
        let device = self.device;
        let all = device.repetition(leading).map_or(&[][..], |repetition| &repetition.axes);
        let nowhere = device.axes.len().saturating_sub(all.len());
        all.iter().copied().chain(std::iter::repeat_n(None, nowhere))
    }
}
