use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::texts::{self, Named};
use crate::lint::words::{Meant, Vocabulary, is_slip, words};
use crate::model::{Device, Section};
use crate::source::{Layer, Node, Value};

rule! {
    /// A name with a misprint is not found by the one who looks for it, and stands in every master's list. It shows where
    /// the profile or other names of the device have a word that is the same but for one letter, a space, or two letters in
    /// the other order. Other endings, and the two ways to spell English, are none. The classes of `severity` are such words, too.
    ///
    /// If the source has the misprint, it stays as printed, and an erratum says what holds.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60D5]
    /// name = "Touch probe 1 positive egde counter"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60D5]
    /// name = "Touch probe 1 positive edges counter"
    /// ```
    pub(super) static RULE = "misspelt-name", Facts, Warning,
        "a name has a misprint";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let names = texts::named(device);
    let mapped = device.pdos.iter().flat_map(|pdo| &pdo.entries).map(|mapped| mapped.name.as_str());
    let vocabulary = Vocabulary::of(names.iter().map(|named| named.name).chain(mapped));
    let is_written =
        |named: &&Named<'_>| named.origin.layer(&named.path).is_some_and(|layer| layer != Layer::Profile);
    for named in names.iter().filter(is_written) {
        let found = against_profile(named, report).or_else(|| against_others(named, &vocabulary));
        if let Some(diagnostic) = found {
            report.push(named.at.clone(), diagnostic);
        }
    }
    severities(device, report);
}

/// The vendor's classes of errors, each of which is one word for many of them.
fn severities(device: &Device, report: &mut Report) {
    let of_errors = device.errors.iter().map(|it| (it.place(), &it.severity, &it.origin));
    let of_codes = device.vendor_codes.iter();
    let of_codes = of_codes.map(|it| (Section::VendorCodes.at(it.code), &it.severity, &it.origin));
    let all: Vec<_> = of_errors
        .chain(of_codes)
        .filter_map(|(at, severity, origin)| Some((at, severity.as_deref()?, origin)))
        .collect();
    let vocabulary = Vocabulary::of(all.iter().map(|(_, severity, _)| *severity));
    for (at, severity, origin) in all {
        let meant = words(severity).iter().find_map(|word| vocabulary.meant(word).cloned());
        let Some(Meant::Word(meant, _)) = meant else { continue };
        let message = format!("the severity of {at} is `{severity}`, where others have `{meant}`");
        let diagnostic = Diagnostic::new(&RULE, message, origin.value("severity"), "perhaps a misprint")
            .help("correct it; if the source has it so, say in an erratum what holds");
        report.push(at.at("severity"), diagnostic);
    }
}

/// A name in which each word is the profile's, or a slip of it; or whose letters are the profile's, but parted elsewhere.
fn against_profile(named: &Named<'_>, report: &Report) -> Option<Diagnostic> {
    let (usual, node) = profile(named, report).filter(|(usual, _)| *usual != named.name)?;
    let (own, theirs) = (words(named.name), words(usual));
    if own == theirs || own.len() != theirs.len() {
        return None;
    }
    let mut differing = own.iter().zip(&theirs).filter(|(word, meant)| word != meant);
    let is_parted = own.concat() == theirs.concat();
    if !is_parted && !differing.clone().all(|(word, meant)| is_slip(word, meant)) {
        return None;
    }
    let (word, meant) = differing.next()?;
    let message = if is_parted {
        format!("{} is called `{}`, with a space in another place than in `{usual}`", named.at, named.name)
    } else {
        format!("{} is called `{}`, with `{word}` for `{meant}`", named.at, named.name)
    };
    let diagnostic = told(named, message).label(node.at, "the profile's name");
    Some(diagnostic)
}

/// A name with a word that other names have otherwise.
fn against_others(named: &Named<'_>, vocabulary: &Vocabulary) -> Option<Diagnostic> {
    if vocabulary.is_regular() {
        return None;
    }
    words(named.name).iter().find_map(|word| {
        let (others, meant) = match vocabulary.meant(word)? {
            Meant::Word(meant, 1) => ("another name has", meant),
            Meant::Word(meant, _) | Meant::Parted(meant) => ("other names have", meant),
        };
        let message =
            format!("{} is called `{}`, with `{word}`, where {others} `{meant}`", named.at, named.name);
        Some(told(named, message))
    })
}

fn told(named: &Named<'_>, message: String) -> Diagnostic {
    let at = named.origin.value(&named.path);
    Diagnostic::new(&RULE, message, at, "perhaps a misprint")
        .help("correct it; if the source has it so, say in an erratum what holds")
}

/// The profile's name for it, which may stand alone or in a table.
fn profile<'d>(named: &Named<'d>, report: &Report) -> Option<(&'d str, &'d Node)> {
    let named_at = |path: &str| {
        let node = report.profile(named.origin, path)?;
        match &node.value {
            Value::String(name) => Some((&**name, node)),
            _ => None,
        }
    };
    let short = || named.path.strip_suffix(".name");
    named_at(&named.path).or_else(|| named_at(short()?)).or_else(|| named_at(&format!("{}.name", named.path)))
}
