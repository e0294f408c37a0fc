//! The generated file, the derive and a build script say the same.

use std::path::Path;

use devc::emit::rust::{Options, text, tokens};
use devc::lint::Checked;
use devc::model::Family;
use devc::source::Disk;
use proc_macro2::{Punct, Spacing, TokenTree};
use quote::{ToTokens, quote};
use syn::visit_mut::VisitMut;
use syn::{Attribute, Expr, Item, Lit, Macro, Meta, MetaNameValue, parse_quote};

const GENERATED: &str = include_str!("../../../generated/c887/c887.rs");

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn family() -> Checked<Family> {
    let compilation = devc::compile(&Disk, &root().join("../devices/c887"));
    compilation.family.expect("the description of the C-887 has no errors")
}

/// Shows the first line that differs: all of both would fill the screen.
fn assert_same(ours: &str, file: &str) {
    for (number, (ours, file)) in (1..).zip(ours.lines().zip(file.lines())) {
        assert_eq!(ours, file, "line {number}");
    }
    assert_eq!(ours.lines().count(), file.lines().count());
}

/// The same layout for the same code, with an attribute for each line of documentation.
fn printed(file: &syn::File) -> String {
    let mut file = file.clone();
    Docs.visit_file_mut(&mut file);
    prettyplease::unparse(&file)
}

/// Takes documentation of several lines apart.
struct Docs;

impl VisitMut for Docs {
    fn visit_attributes_mut(&mut self, attributes: &mut Vec<Attribute>) {
        let lines = |attribute: Attribute| {
            let Meta::NameValue(MetaNameValue { value: Expr::Lit(value), .. }) = &attribute.meta else {
                return vec![attribute];
            };
            let Lit::Str(text) = &value.lit else { return vec![attribute] };
            let (text, style) = (text.value(), attribute.style);
            let line = |line: &str| Attribute { style, ..parse_quote!(#[doc = #line]) };
            text.split('\n').map(line).collect()
        };
        *attributes = std::mem::take(attributes).into_iter().flat_map(lines).collect();
    }

    /// What macros are given is not parsed, but their fields have documentation, too.
    fn visit_macro_mut(&mut self, called: &mut Macro) {
        let mut trees = std::mem::take(&mut called.tokens).into_iter().peekable();
        while let Some(tree) = trees.next() {
            let text =
                trees.peek().filter(|_| matches!(&tree, TokenTree::Punct(sign) if sign.as_char() == '#'));
            let Some(text) = text.and_then(documentation) else {
                called.tokens.extend([apart(tree)]);
                continue;
            };
            trees.next();
            called.tokens.extend(text.split('\n').map(|line| quote!(#[doc = #line])));
        }
    }
}

/// A reference as `quote!` has it: apart from the lifetime behind it.
fn apart(tree: TokenTree) -> TokenTree {
    match tree {
        TokenTree::Punct(sign) if sign.as_char() == '&' => Punct::new('&', Spacing::Alone).into(),
        other => other,
    }
}

/// The text of an attribute's brackets, if it is documentation.
fn documentation(tree: &TokenTree) -> Option<String> {
    let TokenTree::Group(brackets) = tree else { return None };
    let MetaNameValue { path, value: Expr::Lit(value), .. } = syn::parse2(brackets.stream()).ok()? else {
        return None;
    };
    match value.lit {
        Lit::Str(text) if path.is_ident("doc") => Some(text.value()),
        _ => None,
    }
}

#[test]
fn the_checked_in_file_is_current() {
    assert_same(&text(&family(), &Options::default()), GENERATED);
}

#[test]
fn the_text_is_the_tokens() {
    let tokens = syn::parse2(tokens(&family(), &Options::default())).expect("tokens are Rust");
    let text = syn::parse_file(GENERATED).expect("the file is Rust");
    assert_same(&printed(&tokens), &printed(&text));
}

#[test]
fn the_derive_expands_to_the_file() {
    let input = quote!(
        #[device(path = "../devices/c887")]
        pub struct C887;
    );
    let expanded: syn::File =
        syn::parse2(devc::derive::expand(input, root(), &Disk)).expect("the expansion is Rust");
    let (mut outside, mut modules): (Vec<Item>, Vec<Item>) =
        expanded.items.into_iter().partition(|item| !matches!(item, Item::Mod(_)));
    let Some(Item::Mod(module)) = modules.pop() else { panic!("the expansion has no module") };
    assert_eq!(module.ident, "c887");

    // the struct is the user's, and what implements `Device` for it stands beside the module
    let mut file = syn::parse_file(GENERATED).expect("the file is Rust");
    let is_device = |item: &Item| {
        matches!(item, Item::Struct(item) if item.ident == "C887")
            || item.to_token_stream().to_string().starts_with("impl Device for C887")
    };
    let place = file.items.iter().position(is_device).expect("the file declares the device");
    let identity = file.items.remove(place + 1);
    file.items[place] = parse_quote!(
        use super::C887;
    );

    let (_, items) = module.content.expect("the module has content");
    let expanded = syn::File { shebang: None, frontmatter: None, attrs: module.attrs, items };
    assert_same(&inner(&expanded), &inner(&file));
    let as_path = quote!(impl ::devc_runtime::Device for C887).to_string();
    let identity = identity.to_token_stream().to_string().replacen("impl Device for C887", &as_path, 1);
    assert_eq!(outside.remove(0).to_token_stream().to_string(), identity);
    assert!(outside.iter().all(|item| item.to_token_stream().to_string().contains("include_bytes")));
}

/// The code without the attributes of the file itself, whose order a parser may change.
fn inner(file: &syn::File) -> String {
    printed(&syn::File { attrs: Vec::new(), ..file.clone() })
}

#[test]
fn a_build_script_gets_the_file_in_a_module() {
    let name = devc::emit::rust::snake("c887");
    let module = devc::emit::rust::module(&family(), &name, &Options::default());
    let parsed = syn::parse_file(&module).expect("the file is Rust");
    let [Item::Mod(module)] = parsed.items.as_slice() else { panic!("the file is a module") };
    let items = module.content.clone().expect("the module has content").1;
    let file = syn::parse_file(GENERATED).expect("the file is Rust");
    assert_same(&inner(&syn::File { items, ..file.clone() }), &inner(&file));
}
