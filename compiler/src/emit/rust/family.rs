//! A family: what its members share stands once, in its own module or in that of the first member that has it.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::braces::braces;
use super::contents::Contents;
use super::doc::{Doc, escape};
use super::item::{Holders, Item, Reach, Space};
use super::names::{Names, snake};
use super::scope::Scope;
use super::sharing::{Home, Sharing};
use super::{Options, contents, head};
use crate::lint::Checked;
use crate::model::{Device, Family, Pair, Unit};

/// The content of the module of a family.
pub(super) fn tokens(family: &Checked<Family>, options: &Options) -> TokenStream {
    let unlike = unlike(&family.members);
    let scope =
        |(device, place)| Scope { unlike: unlike.clone(), ..Scope::new(device, Some(place), options) };
    let scopes: Vec<Scope<'_>> = family.members.iter().zip(0..).map(scope).collect();
    let contents: Vec<Contents<'_>> = scopes.iter().map(|scope| contents::of(scope, options)).collect();
    let sharing = Sharing::of(&family.members, &contents);
    let mut names = Names::with(&["commands", "objects", "configurations", "units", "dictionary"]);
    let modules = family.members.iter().map(|device| names.claim(&snake(&device.id))).collect();
    let file = File { family, scopes: &scopes, contents, sharing, modules };
    file.tokens(&options.runtime)
}

/// The units that differ between members.
fn unlike(members: &[Device]) -> BTreeSet<&str> {
    let mut known: BTreeMap<&str, (&Device, &Unit)> = BTreeMap::new();
    let mut unlike = BTreeSet::new();
    for (device, unit) in
        members.iter().flat_map(|device| device.units.iter().map(move |unit| (device, unit)))
    {
        let (first, one) = *known.entry(&unit.id).or_insert((device, unit));
        if !Pair::of(first, device).is_one(one, unit) {
            unlike.insert(unit.id.as_str());
        }
    }
    unlike
}

struct File<'f, 's> {
    family: &'f Family,
    scopes: &'s [Scope<'f>],
    contents: Vec<Contents<'s>>,
    sharing: Sharing,
    /// The names of the members' modules.
    modules: Vec<Ident>,
}

impl File<'_, '_> {
    fn tokens(&self, runtime: &TokenStream) -> TokenStream {
        let title = Doc::new(format!("The devices of the family {}.", escape(&self.family.name)))
            .maybe(self.family.about.as_deref())
            .inner();
        let (allowed, imports) = (head::allowed(), head::imports(self.scopes));
        let reason = "a family may bear the name of a member";
        let (owner, shared) = (self.owner(runtime), self.shared(runtime));
        let members = (0..self.modules.len()).map(|member| self.member(member, runtime));
        quote! {
            #title
            #allowed
            #![allow(clippy::module_inception, reason = #reason)]
            #imports
            #owner
            #(#shared)*
            #(#members)*
        }
    }

    /// The type that entries and process data belong to.
    fn owner(&self, runtime: &TokenStream) -> TokenStream {
        let modules = &self.modules;
        quote! {
            /// Any of these devices: what the entries and the process data of the family belong to.
            #[derive(Debug, Clone, Copy, PartialEq, Eq)]
            pub enum Family {}

            impl #runtime::Family for Family {
                const MEMBERS: &'static [BringUp] = &[#(#modules::BRING_UP),*];
            }
        }
    }

    /// What stands in the module of the family.
    fn shared(&self, runtime: &TokenStream) -> Vec<TokenStream> {
        let runs = self.contents.first().map(Vec::as_slice).unwrap_or_default();
        let modules = runs.iter().enumerate().map(|(run, (space, _))| {
            let items = self.contents.iter().enumerate().flat_map(|(member, contents)| {
                let items = contents.get(run).map(|(_, items)| items.as_slice()).unwrap_or_default();
                items
                    .iter()
                    .filter(move |item| {
                        self.sharing.home(*space, item, member) == Home::Family
                            && self.sharing.first(*space, item, member) == member
                    })
                    .map(move |item| item.shared_tokens(&self.holders(*space, item, member)))
            });
            match space {
                Space::Root => items.collect(),
                space => space.module(runtime, items),
            }
        });
        modules.collect()
    }

    fn holders(&self, space: Space, item: &Item<'_>, member: usize) -> Holders<'_> {
        let holders = self.sharing.holders(space, item, member);
        let names = holders.iter().filter_map(|holder| self.family.members.get(*holder));
        Holders {
            places: holders.iter().filter_map(|holder| u16::try_from(*holder).ok()).collect(),
            names: names.map(|device| device.name.as_str()).collect(),
            is_all: holders.len() == self.modules.len(),
        }
    }

    /// The module of a member: what it is, what it has of others, and what is its own.
    fn member(&self, member: usize, runtime: &TokenStream) -> TokenStream {
        let (Some(scope), Some(name), Some(contents)) =
            (self.scopes.get(member), self.modules.get(member), self.contents.get(member))
        else {
            return TokenStream::new();
        };
        let docs = head::module_doc(scope.device).inner();
        let device = head::device(scope);
        let root = contents.iter().filter(|(space, _)| *space == Space::Root).flat_map(|(_, items)| items);
        let whole: Vec<Ident> = self.whole_modules(member, contents);
        let used = self.used(Space::Root, root, member, whole);
        let runs = contents.iter().map(|(space, items)| match space {
            Space::Root => self.own(Space::Root, items, member).collect(),
            space if self.is_whole(*space, items, member) => TokenStream::new(),
            space => {
                let used = self.used(*space, items.iter(), member, Vec::new());
                let own = self.own(*space, items, member);
                let items = [used].into_iter().filter(|used| !used.is_empty()).chain(own);
                space.module(runtime, items)
            }
        });
        let imports = quote!(
            use super::*;
        );
        let content = braces([docs, imports, used, device].into_iter().chain(runs));
        quote!(pub mod #name #content)
    }

    /// The items that stand with the member.
    fn own<'i>(
        &'i self,
        space: Space,
        items: &'i [Item<'_>],
        member: usize,
    ) -> impl Iterator<Item = TokenStream> + 'i {
        let own =
            items.iter().filter(move |item| self.sharing.home(space, item, member) == Home::Member(member));
        own.map(move |item| item.tokens(&self.holders(space, item, member)))
    }

    /// The modules that are just those of the family.
    fn whole_modules(&self, member: usize, contents: &Contents<'_>) -> Vec<Ident> {
        let whole = contents.iter().filter(|(space, items)| self.is_whole(*space, items, member));
        whole.map(|(space, _)| space.name()).collect()
    }

    /// Whether a member has in a module just what the family has there.
    fn is_whole(&self, space: Space, items: &[Item<'_>], member: usize) -> bool {
        space != Space::Root
            && !items.is_empty()
            && items.iter().all(|item| self.sharing.home(space, item, member) == Home::Family)
            && items.len() == self.sharing.in_family(space)
    }

    /// The imports of what the member has but what stands elsewhere.
    fn used<'i>(
        &self,
        space: Space,
        items: impl Iterator<Item = &'i Item<'i>>,
        member: usize,
        whole: Vec<Ident>,
    ) -> TokenStream {
        let mut names: BTreeMap<(Home, bool), Vec<Ident>> = BTreeMap::new();
        if !whole.is_empty() {
            names.insert((Home::Family, true), whole);
        }
        for item in items {
            let home = self.sharing.home(space, item, member);
            if home != Home::Member(member) {
                let is_public = item.reach == Reach::Public;
                names.entry((home, is_public)).or_default().extend(item.names.iter().cloned());
            }
        }
        let imports = names.into_iter().map(|((home, is_public), names)| {
            let path = self.path(space, home);
            let public = is_public.then(|| quote!(pub));
            match names.as_slice() {
                [only] => quote!(#public use #path::#only;),
                names => quote!(#public use #path::{#(#names),*};),
            }
        });
        imports.collect()
    }

    /// The way from a module of a member to the same of another.
    fn path(&self, space: Space, home: Home) -> TokenStream {
        let member = match home {
            Home::Member(member) => self.modules.get(member),
            Home::Family => None,
        };
        let member = member.map(|member| quote!(::#member));
        match space {
            Space::Root => quote!(super #member),
            space => {
                let space = format_ident!("{}", space.name());
                quote!(super::super #member::#space)
            }
        }
    }
}
