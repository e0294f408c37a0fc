//! Families: what members share is one item, what differs is two, and what one lacks it does not have.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use devc_generated::{pmc_sc6, s700};
use devc_runtime::Family;
use devc_runtime::pdo::{Pdo, ProcessImage};
use devc_runtime::start_up::{BringUp, StartUp, Write};
use quote::quote;
use serde_json::Value;
use syn::{File, Item, ItemMod, UseTree};

/// Types that are one type: what is a value of the one is a value of the other.
macro_rules! one {
    ($($one:path, $other:path;)+) => {
        $(const _: fn($one) -> $other = |value| value;)+
    };
}
one! {
    s700::Controlword, s700::s300::Controlword;
    s700::s300::Controlword, s700::s400::Controlword;
    s700::s300::RxPdo1702, s700::s700::RxPdo1702;
    s700::s400::Outputs, s700::s600::Outputs;
    s700::s300::Outputs, s700::s700::Outputs;
    // bits of the S700 have other meanings
    s700::s300::DigitalIo, s700::s600::DigitalIo;
    pmc_sc6::single::Statusword, pmc_sc6::double_hires::Statusword;
    pmc_sc6::double::RxPdo1600, pmc_sc6::double_hires::RxPdo1600;
    pmc_sc6::single::Inputs, pmc_sc6::single_hires::Inputs;
    pmc_sc6::double::Axis, pmc_sc6::double_hires::Axis;
}

/// A program for any member: its images are of PDOs that all have.
#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Outputs {
    setpoint: s700::RxPdo1701,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Inputs {
    actual: s700::TxPdo1B01,
}

/// Only the S300 and the S700 have the object, and the PDO with it.
#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
struct Mapped {
    setpoint: s700::RxPdo1710,
}

#[test]
fn members_take_the_images_whose_pdos_they_have() {
    let takes = |image: fn(&devc_runtime::start_up::BringUp) -> bool| -> Vec<&str> {
        s700::Family::MEMBERS.iter().filter(|member| image(member)).map(|member| member.name).collect()
    };
    assert_eq!(takes(|member| member.takes::<Outputs>() && member.takes::<Inputs>()).len(), 4);
    let model = model("s700");
    let with_pdo = model["members"].as_array().expect("there are members").iter().filter(|member| {
        let pdos = member["pdos"].as_array().expect("there are PDOs");
        pdos.iter().any(|pdo| pdo["index"] == s700::RxPdo1710::INDEX)
    });
    let names: Vec<&str> = with_pdo.filter_map(|member| member["name"].as_str()).collect();
    assert!(!names.is_empty() && names.len() < 4);
    assert_eq!(takes(|member| member.takes::<Mapped>()), names);
}

/// The list is that of each member: none of what differs between them bears on it.
#[test]
fn a_start_up_list_is_made_once_for_all() {
    const ALL: StartUp = StartUp::of::<Outputs, Inputs>();
    const LIST: [Write; ALL.len()] = ALL.writes();
    for member in s700::Family::MEMBERS {
        let own: [Write; LIST.len()] = StartUp::on::<Outputs, Inputs>(member).writes();
        assert_eq!(own, LIST, "{}", member.name);
    }
}

#[test]
fn a_device_that_has_not_the_process_data_takes_no_list_for_it() {
    let without = |member: &&BringUp| !member.takes::<Mapped>();
    let member: &'static BringUp = s700::Family::MEMBERS.iter().find(without).expect("not all have it");
    let refused = std::panic::catch_unwind(|| StartUp::on::<Mapped, Inputs>(member));
    let said = refused.expect_err("it has not this PDO");
    let said = said.downcast_ref::<String>().map_or("", String::as_str);
    assert_eq!(said, format!("{} does not take these images", member.name));
}

fn path(family: &str, end: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../generated/{family}/{family}.{end}"))
}

fn model(family: &str) -> Value {
    let text = std::fs::read_to_string(path(family, "json")).expect("the output is there");
    serde_json::from_str(&text).expect("it is JSON")
}

/// The modules of a generated file, by the names that lead to them.
struct Modules(BTreeMap<Vec<String>, Vec<Item>>);

impl Modules {
    fn read(family: &str) -> Self {
        let text = std::fs::read_to_string(path(family, "rs")).expect("the output is there");
        let file: File = syn::parse_file(&text).expect("it is Rust");
        let mut modules = Self(BTreeMap::new());
        modules.add(Vec::new(), file.items);
        modules
    }

    fn add(&mut self, path: Vec<String>, items: Vec<Item>) {
        for item in &items {
            if let Item::Mod(ItemMod { ident, content: Some((_, inner)), .. }) = item {
                let path = path.iter().cloned().chain([ident.to_string()]).collect();
                self.add(path, inner.clone());
            }
        }
        self.0.insert(path, items);
    }

    /// Where an item stands that goes by a path, with its first line of documentation; nothing if there is none that
    /// can be used from outside.
    fn place(&self, path: &[String]) -> Option<(Vec<String>, String)> {
        let (name, module) = path.split_last()?;
        let items = match self.0.get(module) {
            Some(items) => items,
            None => {
                return self
                    .place(&self.place(module)?.0.into_iter().chain([name.clone()]).collect::<Vec<_>>());
            }
        };
        if let Some(doc) = items.iter().find_map(|item| declared(item, name)) {
            return Some((path.to_vec(), doc));
        }
        let uses = items.iter().filter_map(|item| match item {
            Item::Use(used) if matches!(used.vis, syn::Visibility::Public(_)) => Some(used),
            _ => None,
        });
        let target =
            uses.filter(|used| used.leading_colon.is_none()).find_map(|used| leads(&used.tree, name))?;
        let mut from = module.to_vec();
        for step in &target {
            match step.as_str() {
                "super" => drop(from.pop()),
                step => from.push(step.to_owned()),
            }
        }
        self.place(&from)
    }

    /// The public names of a module.
    fn names(&self, module: &[String]) -> BTreeSet<String> {
        let place = match self.0.contains_key(module) {
            true => module.to_vec(),
            false => self.place(module).expect("there is such a module").0,
        };
        let mut names = BTreeSet::new();
        for item in &self.0[&place] {
            match item {
                Item::Use(used) if matches!(used.vis, syn::Visibility::Public(_)) => {
                    gather(&used.tree, &mut names)
                }
                Item::Const(item) => drop(names.insert(item.ident.to_string())),
                Item::Fn(item) => drop(names.insert(item.sig.ident.to_string())),
                Item::Mod(item) => drop(names.insert(item.ident.to_string())),
                _ => {}
            }
        }
        names
    }
}

/// The names that a `use` brings.
fn gather(tree: &UseTree, names: &mut BTreeSet<String>) {
    match tree {
        UseTree::Path(path) => gather(&path.tree, names),
        UseTree::Name(name) => drop(names.insert(name.ident.to_string())),
        UseTree::Group(group) => group.items.iter().for_each(|tree| gather(tree, names)),
        _ => {}
    }
}

/// The path by which a `use` brings a name.
fn leads(tree: &UseTree, name: &str) -> Option<Vec<String>> {
    match tree {
        UseTree::Path(path) => {
            leads(&path.tree, name).map(|rest| [path.ident.to_string()].into_iter().chain(rest).collect())
        }
        UseTree::Name(found) => (found.ident == name).then(|| vec![name.to_owned()]),
        UseTree::Group(group) => group.items.iter().find_map(|tree| leads(tree, name)),
        _ => None,
    }
}

/// The first line of the documentation of an item with this name.
fn declared(item: &Item, name: &str) -> Option<String> {
    let (ident, attributes) = match item {
        Item::Const(item) => (&item.ident, &item.attrs),
        Item::Fn(item) => (&item.sig.ident, &item.attrs),
        Item::Mod(item) => (&item.ident, &item.attrs),
        Item::Struct(item) => (&item.ident, &item.attrs),
        Item::Enum(item) => (&item.ident, &item.attrs),
        _ => return None,
    };
    let docs = attributes.iter().filter_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    });
    (ident == name).then(|| docs.map(|line| line.trim().to_owned()).next().unwrap_or_default())
}

/// A value without where it was written.
fn plain(value: &Value) -> Value {
    match value {
        Value::Object(fields) => {
            let fields = fields.iter().filter(|(key, _)| *key != "provenance");
            Value::Object(fields.map(|(key, value)| (key.clone(), plain(value))).collect())
        }
        Value::Array(items) => items.iter().map(plain).collect(),
        other => other.clone(),
    }
}

fn array<'v>(value: &'v Value, key: &str) -> &'v Vec<Value> {
    value[key].as_array().unwrap_or_else(|| panic!("`{key}` is a list"))
}

/// All that bears on what is generated for an object: itself on each axis, the words and units that its entries have,
/// and the axes.
fn facts(member: &Value, object: &Value) -> Vec<Value> {
    let of_all = array(member, "objects").iter().filter(|other| other["leading"] == object["leading"]);
    let entries: Vec<&Value> = array(object, "entries").iter().collect();
    let is_word = |word: &&Value| entries.iter().any(|entry| entry["address"] == word["address"]);
    let is_unit = |unit: &&Value| entries.iter().any(|entry| entry["unit"] == unit["id"]);
    let mut facts: Vec<Value> = of_all.map(plain).collect();
    facts.extend(array(member, "words").iter().filter(is_word).map(plain));
    facts.extend(array(member, "units").iter().filter(is_unit).map(plain));
    facts.extend(array(member, "axes").iter().filter(|_| !object["axis"].is_null()).map(plain));
    facts
}

/// The names in `objects` by the index that their documentation begins with.
fn by_index(modules: &Modules, member: &str) -> BTreeMap<u64, Vec<String>> {
    let space = [member.to_owned(), "objects".to_owned()];
    let mut found = BTreeMap::new();
    for name in modules.names(&space) {
        let path: Vec<String> = space.iter().cloned().chain([name]).collect();
        let (place, doc) = modules.place(&path).expect("it stands somewhere");
        let index = doc.strip_prefix("`0x").and_then(|rest| u64::from_str_radix(rest.get(..4)?, 16).ok());
        assert_eq!(found.insert(index.expect("an index comes first"), place), None, "{path:?}");
    }
    found
}

/// Each object of each member against the same of each other, by the facts in JSON.
#[test]
fn objects_are_shared_just_where_their_facts_are() {
    for family in ["s700", "pmc-sc6"] {
        let (model, modules) = (model(family), Modules::read(family));
        let members = array(&model, "members");
        let id = |member: &Value| member["id"].as_str().expect("it has an id").replace('-', "_");
        let places: Vec<_> = members.iter().map(|member| by_index(&modules, &id(member))).collect();
        let (mut shared, mut apart) = (0, 0);
        for (member, place) in members.iter().zip(&places) {
            let objects: BTreeMap<u64, &Value> = array(member, "objects")
                .iter()
                .map(|it| (it["index"].as_u64().expect("it is a number"), it))
                .collect();
            // nothing else, and of axes that are alike the first
            assert!(place.keys().all(|index| objects.contains_key(index)), "{}", member["id"]);
            for (index, object) in &objects {
                let leading = object["leading"].as_u64().expect("it is a number");
                let Some(here) = place.get(index) else {
                    assert!(
                        leading != *index && place.contains_key(&leading),
                        "0x{index:04X} of {}",
                        member["id"]
                    );
                    continue;
                };
                for (other, there) in members.iter().zip(&places) {
                    let Some(same) = array(other, "objects").iter().find(|it| it["index"] == object["index"])
                    else {
                        assert!(!there.contains_key(index), "0x{index:04X} of {}", other["id"]);
                        continue;
                    };
                    let is_one = there.get(index) == Some(here);
                    assert_eq!(
                        is_one,
                        facts(member, object) == facts(other, same),
                        "0x{index:04X}: {here:?}"
                    );
                    *if is_one { &mut shared } else { &mut apart } += 1;
                }
            }
        }
        assert!(shared > 400 && apart > 10, "{family}: {shared} shared, {apart} apart");
    }
}

/// A member has the names that it would have alone.
#[test]
fn a_member_has_all_that_it_has_alone() {
    for (family, member) in
        [("s700", "s300"), ("s700", "s400"), ("pmc-sc6", "single"), ("pmc-sc6", "double-hires")]
    {
        let modules = Modules::read(family);
        let path = format!("../devices/{family}");
        let input = quote!(
            #[device(path = #path, member = #member)]
            pub struct Alone;
        );
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let alone = devc::derive::expand(input, root, &devc::source::Disk);
        let alone: File = syn::parse2(alone).expect("the expansion is Rust");
        let mut lone = Modules(BTreeMap::new());
        lone.add(Vec::new(), alone.items);
        for (path, items) in &lone.0 {
            let Some((_, module)) = path.split_first() else { continue };
            let own = || [member.replace('-', "_")].into_iter().chain(module.iter().cloned());
            for item in items {
                let (name, is_public) = match item {
                    Item::Struct(item) => (&item.ident, &item.vis),
                    Item::Enum(item) => (&item.ident, &item.vis),
                    Item::Const(item) => (&item.ident, &item.vis),
                    Item::Fn(item) => (&item.sig.ident, &item.vis),
                    Item::Mod(item) => (&item.ident, &item.vis),
                    _ => continue,
                };
                if matches!(is_public, syn::Visibility::Public(_)) {
                    let path: Vec<String> = own().chain([name.to_string()]).collect();
                    let place = modules.place(&path).unwrap_or_else(|| panic!("{path:?} is missing"));
                    assert_eq!(
                        Some(place.1.as_str()),
                        declared(item, &name.to_string()).as_deref().map(|doc| doc
                            .lines()
                            .next()
                            .unwrap_or_default()
                            .trim()),
                        "{path:?}"
                    );
                }
            }
        }
    }
}
