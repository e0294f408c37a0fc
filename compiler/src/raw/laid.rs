//! What holds for a part of an object besides what its own table says.

use std::sync::Arc;

use crate::source::{Member, Members, Node, Table, Value};

/// The keys that an object's table can have for all of its entries.
pub(crate) const SHARED: &[&str] = &[
    "type",
    "access",
    "pdo",
    "safety",
    "category",
    "unit",
    "default",
    "min",
    "max",
    "values",
    "written",
    "backup",
    "setting",
    "effective",
    "stored",
    "functional",
    "trigger",
];

/// The object's table with what differs on some axes laid over. Reasons for what the object says are none for what it is
/// said to be there instead.
pub(super) fn on_axes(differing: &Table, object: &Table) -> Table {
    let mut shared = object.clone();
    shared.members.retain(|member| &*member.key.name != "per-axis");
    let mut laid = differing.over(&shared);
    let (own, whole) = (differing.get("assumed"), object.get("assumed"));
    let is_of_all = whole.is_none_or(|reasons| !matches!(reasons.node.value, Value::Table(_)));
    if let Some(any) = own.or(whole.filter(|_| !is_of_all)) {
        let is_said = |key: &str| key != "entries" && differing.get(key).is_some();
        let of_object = reasons(whole, &shared).into_iter().filter(|reason| !is_said(&reason.key.name));
        let own = Table { at: any.node.at, members: reasons(own, differing) };
        let all = own.over(&Table { at: any.node.at, members: of_object.collect() });
        let node = Node { at: any.node.at, value: Value::Table(Arc::new(all)) };
        laid.members.retain(|member| &*member.key.name != "assumed");
        laid.members.push(Member { node, ..any.clone() });
    }
    laid
}

/// Reasons by key: one for all of a table is one for each thing that it says.
fn reasons(assumed: Option<&Member>, table: &Table) -> Members {
    let Some(assumed) = assumed else { return Members::default() };
    let said = table.members.iter().filter(|said| !matches!(&*said.key.name, "assumed" | "source"));
    match &assumed.node.value {
        Value::Table(keys) => keys.members.clone(),
        _ => said.map(|said| Member { node: assumed.node.clone(), ..said.clone() }).collect(),
    }
}

/// The table of an entry with what the object's table says for all entries. What a description says there is more than
/// what a profile says of the entry.
pub(super) fn with_shared(own: &Table, object: &Table) -> Table {
    let mut table = own.clone();
    for shared in object.members.iter().filter(|member| SHARED.contains(&&*member.key.name)) {
        match table.position(&shared.key.name).and_then(|place| table.members.get_mut(place)) {
            Some(own) if own.layer < shared.layer => {
                *own = Member { under: Some(Arc::new(own.node.clone())), ..shared.clone() };
            }
            Some(own) if own.under.is_none() && shared.layer < own.layer => {
                own.under = Some(Arc::new(shared.node.clone()))
            }
            Some(_) => {}
            None => table.members.push(shared.clone()),
        }
    }
    if let Some(assumed) = assumed(own, object) {
        table.members.retain(|member| member.key.name != assumed.key.name);
        table.members.push(assumed);
    }
    table
}

/// The reasons for what an entry says, and those of the object's table for what that says for all entries, and for its
/// entries; none if the object has no reasons, or the entry one for all of it.
fn assumed(own: &Table, object: &Table) -> Option<Member> {
    let reasons = object.get("assumed")?;
    let inherited = |key: &str| SHARED.contains(&key) && own.get(key).is_none();
    let mut all = match own.get("assumed").map(|own| &own.node.value) {
        None if !matches!(reasons.node.value, Value::Table(_)) => return Some(reasons.clone()),
        None => Table { at: reasons.node.at, members: Members::default() },
        Some(Value::Table(own)) => Table::clone(own),
        Some(_) => return None,
    };
    let shared: Members = match &reasons.node.value {
        Value::Table(keys) => keys.members.clone(),
        _ => {
            object.members.iter().map(|said| Member { node: reasons.node.clone(), ..said.clone() }).collect()
        }
    };
    let of_entries = shared.iter().find(|reason| &*reason.key.name == "entries").cloned();
    let of_entries = of_entries.into_iter().flat_map(|reason| {
        let said = own.members.iter().filter(|said| !matches!(&*said.key.name, "assumed" | "source"));
        said.map(move |said| Member { node: reason.node.clone(), ..said.clone() })
    });
    let shared = shared.iter().filter(|reason| inherited(&reason.key.name)).cloned().chain(of_entries);
    for reason in shared.filter(|reason| all.get(&reason.key.name).is_none()).collect::<Members>() {
        all.members.push(reason);
    }
    let node = Node { at: reasons.node.at, value: Value::Table(Arc::new(all)) };
    Some(Member { node, ..reasons.clone() })
}
