//! Whole process images: the one that a device has if nobody changes its assignment, and others.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::axes::Placed;
use super::doc::Doc;
use super::item::{Item, Space};
use super::literal::number;
use super::names::{Names, snake};
use super::packing::{self, Layout};
use super::scope::Scope;
use crate::model::{Direction, Index, Pdo, Role, SyncManager};

/// A field of an image.
struct Part<'a, 'p> {
    pdo: &'p Placed<'a, Pdo>,
    name: Ident,
    /// The axis of the first of them.
    axis: usize,
    /// Whether it is the PDOs of all axes, one after the other.
    of_axes: bool,
}

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    [Direction::Rx, Direction::Tx].into_iter().filter_map(|way| item(scope, way)).collect()
}

fn item<'s>(scope: &'s Scope<'_>, way: Direction) -> Option<Item<'s>> {
    let manager = scope.device.sync_manager(Role::of(way))?;
    let image = by_default(scope, way)?;
    let (pdos, shifts): (Vec<Ident>, Vec<Option<u16>>) =
        image.parts.iter().map(|part| (scope.pdo_ident(part.pdo), part.pdo.shift)).unzip();
    let bytes = scope.device.image_bytes(manager.role);
    let item = Item::new(name(way), move || (doc(scope, way, manager), image.code(scope)));
    let item = item.with_name(format_ident!("{}View", name(way))).of(manager).told(bytes);
    let item = item.each(pdos, |item, pdo| item.using(Space::Root, &pdo));
    Some(item.each(shifts, |item, shift| scope.placed(item, shift)))
}

fn doc(scope: &Scope<'_>, way: Direction, manager: &SyncManager) -> Doc {
    let title = match way {
        Direction::Rx => "The outputs of the master",
        Direction::Tx => "The inputs of the master",
    };
    let length = scope.device.image_bytes(manager.role);
    Doc::new(format!("{title} with the PDOs assigned by default, {length} bytes.")).said(
        manager.source.as_ref(),
        &manager.origin,
        scope.device,
    )
}

/// The image by default; none if there are no PDOs in it, or if one of them ends within a byte.
pub(super) fn by_default<'a, 's>(scope: &'s Scope<'a>, way: Direction) -> Option<Image<'a, 's>> {
    let manager = scope.device.sync_manager(Role::of(way))?;
    let assigned: Vec<Index> = scope.device.assigned(manager.role).map(|pdo| pdo.index).collect();
    let pdos: Vec<&Placed<'_, Pdo>> = scope.pdos.iter().collect();
    Image::of(&pdos, &assigned, way).filter(|_| !assigned.is_empty())
}

/// An image of PDOs.
pub(super) struct Image<'a, 'p> {
    pub(super) way: Direction,
    parts: Vec<Part<'a, 'p>>,
}

impl<'a, 'p> Image<'a, 'p> {
    /// An image of PDOs out of these; none if one of them ends within a byte.
    pub(super) fn of(pdos: &[&'p Placed<'a, Pdo>], assigned: &[Index], way: Direction) -> Option<Self> {
        Some(Self { way, parts: parts(pdos, assigned)? })
    }

    /// All of it but the documentation.
    pub(super) fn code(&self, scope: &Scope<'_>) -> TokenStream {
        let Self { way, parts } = self;
        let fields = parts.iter().map(|part| field(scope, part));
        let pdos = parts.iter().flat_map(|part| selected(scope, part));
        let (name, direction) = (name(*way), super::pdos::direction(*way));
        let count = |part: &Part<'_, '_>| u32::try_from(part.count()).unwrap_or(0);
        let length = parts.iter().map(|part| part.pdo.first.bytes() * count(part)).sum();
        let packing = packing::items(scope, &name, direction, &layout(scope, parts, length));
        quote! {
            #[derive(Debug, Clone, Copy, PartialEq)]
            pub struct #name { #(#fields)* }

            #packing

            impl ProcessImage for #name {
                const PDOS: &'static [MappedPdo] = &[#(#pdos),*];
            }
        }
    }
}

/// The name of the image of a direction.
pub(super) fn name(way: Direction) -> Ident {
    match way {
        Direction::Rx => format_ident!("Outputs"),
        Direction::Tx => format_ident!("Inputs"),
    }
}

impl Part<'_, '_> {
    /// How many PDOs it is.
    fn count(&self) -> usize {
        if self.of_axes { self.pdo.all.len() } else { 1 }
    }
}

/// The assigned PDOs, those of all axes in a row put together.
fn parts<'a, 'p>(pdos: &[&'p Placed<'a, Pdo>], mut assigned: &[Index]) -> Option<Vec<Part<'a, 'p>>> {
    let (mut parts, mut names) = (Vec::new(), Names::default());
    while let Some((first, rest)) = assigned.split_first() {
        let pdo = *pdos.iter().find(|pdo| pdo.all.iter().any(|one| one.index == *first))?;
        if !pdo.first.bits().is_multiple_of(8) {
            return None;
        }
        let axis = pdo.all.iter().position(|one| one.index == *first).unwrap_or(0);
        let row = pdo.all.iter().map(|pdo| &pdo.index);
        let of_axes = pdo.shift.is_some() && assigned.iter().take(pdo.all.len()).eq(row);
        let direction = if pdo.id.starts_with("rx") { "rx" } else { "tx" };
        let id =
            if of_axes { "axes".to_owned() } else { format!("{direction}-pdo-{first:04X}", first = first.0) };
        assigned = if of_axes { assigned.get(pdo.all.len()..).unwrap_or_default() } else { rest };
        parts.push(Part { pdo, name: names.claim(&snake(&id)), axis, of_axes });
    }
    Some(parts)
}

fn field(scope: &Scope<'_>, part: &Part<'_, '_>) -> TokenStream {
    let (name, pdo) = (&part.name, scope.pdo_ident(part.pdo));
    let title = super::doc::escape(&part.pdo.first.name);
    if part.of_axes {
        let (doc, count) = (Doc::new(format!("{title} of each axis, in order.")), number(part.pdo.all.len()));
        return quote!(#doc pub #name: [#pdo; #count],);
    }
    let doc = Doc::new(format!("{title}."));
    quote!(#doc pub #name: #pdo,)
}

/// The PDOs with what is mapped to them.
fn selected(scope: &Scope<'_>, part: &Part<'_, '_>) -> Vec<TokenStream> {
    let (runtime, pdo) = (scope.runtime, scope.pdo_ident(part.pdo));
    let selected = (part.axis..part.axis + part.count()).map(|axis| {
        let axis = number(axis);
        quote!(#runtime::pdo::of_axis::<#pdo>(#axis))
    });
    selected.collect()
}

/// The bytes of the PDOs, one after the other.
fn layout(scope: &Scope<'_>, parts: &[Part<'_, '_>], length: u32) -> Layout {
    let bytes: Vec<Ident> = (0..length).map(|number| format_ident!("b{number}")).collect();
    let mut rest = bytes.as_slice();
    let (mut pack, mut unpack) = (TokenStream::new(), TokenStream::new());
    for part in parts {
        let (name, pdo) = (&part.name, scope.pdo_ident(part.pdo));
        let size = usize::try_from(part.pdo.first.bytes()).unwrap_or(0);
        let mut take = || {
            let (taken, left) = rest.split_at_checked(size).unwrap_or((rest, &[]));
            rest = left;
            taken
        };
        if part.of_axes {
            let axes: Vec<Ident> = scope.axis_idents().into_iter().map(|(_, variable)| variable).collect();
            let taken: Vec<&[Ident]> = axes.iter().map(|_| take()).collect();
            pack.extend(quote!(let [#(#axes),*] = self.#name; #(let [#(#taken),*] = #axes.pack();)*));
            unpack.extend(quote!(#name: [#(#pdo::unpack([#(#taken),*])),*],));
        } else {
            let taken = take();
            pack.extend(quote!(let [#(#taken),*] = self.#name.pack();));
            unpack.extend(quote!(#name: #pdo::unpack([#(#taken),*]),));
        }
    }
    let pattern = quote!([#(#bytes),*]);
    let view = (quote!(of PDOs in), views(scope, parts));
    let (pack, unpack, inline) = (quote!(#pack #pattern), quote!(Self { #unpack }), quote!(#[inline]));
    Layout { length, pack, pattern, unpack, view, inline }
}

/// A line for each field: its view to read and to write, the PDO, and its first byte.
fn views(scope: &Scope<'_>, parts: &[Part<'_, '_>]) -> TokenStream {
    let mut names = Names::default();
    for part in parts {
        names.claim(&part.name);
    }
    let mut offset = 0;
    let mut lines = TokenStream::new();
    for part in parts {
        let (name, pdo, at) = (&part.name, scope.pdo_ident(part.pdo), number(offset));
        let name_mut = names.claim(&format_ident!("{name}_mut"));
        let axes = scope.axis_idents().into_iter().map(|(_, variable)| variable);
        let content = if part.of_axes { quote!([#pdo; #(#axes),*]) } else { quote!(#pdo) };
        lines.extend(quote!(#name, #name_mut: #content => #at;));
        offset += part.pdo.first.bytes() * u32::try_from(part.count()).unwrap_or(0);
    }
    lines
}
