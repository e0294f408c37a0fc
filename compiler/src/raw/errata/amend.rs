//! What holds, laid over what is written.

use std::sync::Arc;

use super::{Step, quote};
use crate::raw::compose::forget;
use crate::source::{Layer, Member, Members, Node, Table, Value};

/// The mark that an erratum leaves at the keys it is about.
pub(super) struct Mark {
    /// Who says what holds of them.
    layer: Layer,
    /// The erratum, by its number in the list, whose mark stands at one of them already: a key has one.
    pub(super) other: Option<u16>,
}

impl Mark {
    pub(super) fn of(layer: Layer) -> Self {
        Self { layer, other: None }
    }

    fn set(&mut self, member: &mut Member) {
        self.meet(member.layer);
        member.layer = self.layer;
    }

    fn meet(&mut self, there: Layer) {
        if let Layer::Corrected(other) | Layer::Contradicted(other) = there
            && there != self.layer
        {
            self.other = Some(other);
        }
    }
}

/// Lays `holds` over what stands at a path, in place of what `says` quotes there; without it, marks what is quoted.
pub(super) fn amend(tree: &mut Table, path: &[Step], says: &Node, holds: Option<&Node>, mark: &mut Mark) {
    let Some((Step::Key(key), rest)) = path.split_first() else { return };
    let Some(member) = tree.position(key).and_then(|place| tree.members.get_mut(place)) else { return };
    if rest.is_empty() {
        return member_amended(member, says, holds, mark);
    }
    match &mut member.node.value {
        Value::Table(table) => amend(Arc::make_mut(table), rest, says, holds, mark),
        Value::Array(items) => {
            let mut list = items.to_vec();
            let mut is_marked = false;
            if let Some((Step::Item(place), rest)) = rest.split_first()
                && let Some(item) = list.get_mut(*place)
            {
                item_amended(item, rest, says, holds, mark);
                is_marked = item.table().is_some();
            }
            *items = list.into();
            // A value in a list has no mark of its own.
            if !is_marked {
                mark.set(member);
            }
        }
        _ => {}
    }
}

fn item_amended(item: &mut Node, rest: &[Step], says: &Node, holds: Option<&Node>, mark: &mut Mark) {
    if let Some(table) = spelt_out(item, says).filter(|_| rest.is_empty()) {
        item.value = Value::Table(Arc::new(table));
    }
    match (&mut item.value, holds) {
        (Value::Table(table), _) if !rest.is_empty() => amend(Arc::make_mut(table), rest, says, holds, mark),
        (Value::Table(table), _) => laid(Arc::make_mut(table), says, holds, mark),
        (_, Some(holds)) => *item = holds.clone(),
        (_, None) => {}
    }
}

/// The table that a text stands for, if an erratum quotes keys of that.
fn spelt_out(item: &Node, says: &Node) -> Option<Table> {
    let word = quote::word(says.table().filter(|_| item.table().is_none())?)?;
    let only = Member { node: item.clone(), layer: Layer::Description, under: None, ..word.clone() };
    Some(Table { at: item.at, members: vec![only].into() })
}

/// A key with what holds for it.
fn member_amended(member: &mut Member, says: &Node, holds: Option<&Node>, mark: &mut Mark) {
    match (&mut member.node.value, holds) {
        (Value::Table(table), _) if says.table().is_some() => laid(Arc::make_mut(table), says, holds, mark),
        (_, holds) => {
            if let Some(holds) = holds {
                let printed = std::mem::replace(&mut member.node, holds.clone());
                member.under.get_or_insert_with(|| Arc::new(printed));
            }
            mark.set(member);
        }
    }
}

/// A table with what holds for the keys that are quoted of it: those for which nothing holds are gone.
fn laid(table: &mut Table, says: &Node, holds: Option<&Node>, mark: &mut Mark) {
    let none = Table { at: table.at, members: Members::default() };
    let says = says.table().map_or(&none, |says| says);
    let gone = table.members.gone().iter().filter(|(key, _)| says.get(key).is_some());
    gone.for_each(|(_, layer)| mark.meet(*layer));
    let Some(held) = holds.and_then(Node::table) else {
        for quoted in &says.members {
            if let Some(place) = table.position(&quoted.key.name)
                && let Some(member) = table.members.get_mut(place)
            {
                member_amended(member, &quoted.node, None, mark);
            }
        }
        return;
    };
    let is_gone = |key: &str| says.get(key).is_some() && held.get(key).is_none();
    table.members.take_away(mark.layer, |member| is_gone(&member.key.name));
    says.members.iter().filter(|it| is_gone(&it.key.name)).for_each(|it| forget(table, &it.key.name));
    for new in &held.members {
        let quoted = says.get(&new.key.name).map_or(&new.node, |quoted| &quoted.node);
        match table.position(&new.key.name).and_then(|place| table.members.get_mut(place)) {
            Some(member) => member_amended(member, quoted, Some(&new.node), mark),
            None => table.members.push(Member { layer: mark.layer, ..new.clone() }),
        }
    }
}
