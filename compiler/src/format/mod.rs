//! The one layout of descriptions: order of keys, alignment, forms of numbers, blank lines.
//!
//! What a text says stays as it is: it is read again and compared before it is given out.

mod lead;
mod line;
mod number;
mod order;
mod page;
mod same;
mod value;

use crate::diagnostic::Diagnostics;
use crate::source::{Layer, SourceFile, Sources, parse};
use page::Page;
use same::same;

/// Lays out the text of a file of a description or a profile.
///
/// # Errors
/// If it is not TOML: what is wrong with it, and the text that this points into.
pub fn format(path: &str, text: &str) -> Result<String, (Diagnostics, Sources)> {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let file = sources.add(SourceFile { path: path.to_owned(), text: text.to_owned(), embedded: false });
    let before = parse::parse(file, text, Layer::Description, &mut diagnostics);
    if diagnostics.has_errors() {
        diagnostics.finish();
        return Err((diagnostics, sources));
    }
    let laid_out = lay_out(text);
    let after = parse::parse(file, &laid_out, Layer::Description, &mut diagnostics);
    // a layout is never worth a change of what is said
    let is_safe = !diagnostics.has_errors() && same(&before, &after);
    debug_assert!(is_safe, "a layout changed what is said");
    Ok(if is_safe { laid_out } else { text.to_owned() })
}

/// The text in its layout, with the ends of lines that its first line has.
fn lay_out(text: &str) -> String {
    let is_windows =
        text.find('\n').is_some_and(|end| text.get(..end).is_some_and(|line| line.ends_with('\r')));
    let (mark, text) = text.strip_prefix('\u{feff}').map_or(("", text), |text| ("\u{feff}", text));
    let text = text.replace("\r\n", "\n");
    let page = Page::of(&text).print();
    let page = if is_windows { page.replace('\n', "\r\n") } else { page };
    format!("{mark}{page}")
}

#[cfg(test)]
mod tests {
    use super::format;

    #[track_caller]
    fn becomes(text: &str, expected: &str) {
        let once = format("device.toml", text).expect("is TOML");
        assert_eq!(once, expected);
        assert_eq!(format("device.toml", &once).expect("is TOML"), once, "twice");
    }

    #[test]
    fn keys_stand_in_the_order_of_the_format_and_below_each_other() {
        becomes(
            "[device]\nvendor='V' # who\n# what\nname = \"N\"\nprofile=402\n",
            "[device]\n# what\nname    = \"N\"\nvendor  = 'V' # who\nprofile = 402\n",
        );
        becomes(
            "[rx-pdos.0x1600]\nentries = [ \"a\",\"b\", ]\nname=\"N\"\n",
            "[rx-pdos.0x1600]\nname    = \"N\"\nentries = [\"a\", \"b\"]\n",
        );
        becomes(
            "[objects]\n0x2000 = {access=\"ro\",type=\"INT8\",name=\"N\"}\n",
            "[objects]\n0x2000 = { name = \"N\", type = \"INT8\", access = \"ro\" }\n",
        );
    }

    #[test]
    fn a_range_has_one_spelling_and_what_ends_before_it_begins_is_a_word() {
        becomes("[rx-pdos]\n\"0x1601 ..= 0x160a\" = {}\n", "[rx-pdos]\n\"0x1601..=0x160A\" = {}\n");
        becomes("[rx-pdos]\n\"0x160a..=0x1601\" = {}\n", "[rx-pdos]\n\"0x160a..=0x1601\" = {}\n");
        becomes("[objects.0x2000.entries]\n\"1..=0\" = {}\n", "[objects.0x2000.entries]\n\"1..=0\" = {}\n");
    }

    #[test]
    fn dotted_keys_follow_and_stand_alone() {
        becomes(
            "[objects.0x6060]\nper-axis.\"Y..=W\" = { functional = false }\naccess=\"ro\"\nid = \"mode\"\n",
            "[objects.0x6060]\nid     = \"mode\"\naccess = \"ro\"\nper-axis.\"Y..=W\" = { functional = false }\n",
        );
    }

    #[test]
    fn indices_have_one_form() {
        becomes(
            "[objects.\"0x60fe\".entries]\n\"1\" = { default = 0xabcd }\n[areas.\"0x6000..=0x67ff\"]\nname = \"A\"\n\
             [objects.24640]\n[errors]\n0X2310 = { name = \"E\" }\n\"0xff00..=0xffff\" = { name = \"F\" }\n",
            "[areas.\"0x6000..=0x67FF\"]\nname = \"A\"\n\n[objects.0x60FE.entries]\n1 = { default = 0xABCD }\n\n\
             [objects.0x6040]\n\n[errors]\n0x2310            = { name = \"E\" }\n\"0xFF00..=0xFFFF\" = { name = \"F\" }\n",
        );
        becomes(
            "[rx-pdos.0x1600]\nname = \"0x1a\"\nentries = [\"0x60ff\", { entry = '0x60c1:0a' }, \"x\"]\n",
            "[rx-pdos.0x1600]\nname    = \"0x1a\"\nentries = [\"0x60FF\", { entry = '0x60C1:0A' }, \"x\"]\n",
        );
        becomes(
            "[identity]\nvendor-id = 1901\nproduct-code = 0xab\nrevision = 1\n",
            "[identity]\nvendor-id    = 0x0000076D\nproduct-code = 0x000000AB\nrevision     = 1\n",
        );
    }

    #[test]
    fn lists_keep_their_lines_and_comments() {
        becomes(
            "include=[ # files\n\"a\" , \"b\"\n  ,\n\n # c\n\"c\" ]\n[x]\nd = [\n[1],{a=1,},\n]",
            "include = [ # files\n    \"a\", \"b\",\n\n    # c\n    \"c\"]\n\n[x]\nd = [\n    [1], { a = 1 },\n]\n",
        );
    }

    #[test]
    fn tables_of_one_thing_stand_together() {
        becomes(
            "# head\n\n\n[words.a]\nabout = \"A\"\n\n[words.a.bits]\n0 = \"a\"\n\n\n[words.b]\n[[errata]]\nrule = \"r\"\n[errata.says]\na = 1\n[[errata]]\n\n",
            "# head\n\n[words.a]\nabout = \"A\"\n[words.a.bits]\n0 = \"a\"\n\n[words.b]\n\n[[errata]]\nrule = \"r\"\n[errata.says]\na = 1\n\n[[errata]]\n",
        );
    }

    #[test]
    fn sections_are_ordered_unless_a_heading_stands_between() {
        becomes(
            "# head\n\n[states.a]\n# of b\n[states.b]\n[device]\n",
            "# head\n\n[device]\n\n[states.a]\n\n# of b\n[states.b]\n",
        );
        becomes(
            "[states.a]\n\n# ---- heading ----\n\n[device]\n",
            "[states.a]\n\n# ---- heading ----\n\n[device]\n",
        );
    }

    #[test]
    fn what_groups_keys_is_kept() {
        becomes(
            "[device]\n# first\nvendor = \"V\"\nname = \"N\"\n\n\n# second\nprofile = 1\ngroup = \"G\"\n",
            "[device]\n# first\nvendor = \"V\"\nname   = \"N\"\n\n# second\nprofile = 1\ngroup   = \"G\"\n",
        );
    }

    #[test]
    fn lines_end_as_they_did() {
        becomes("[device]\r\nname=\"\"\"\r\na\r\n\"\"\"\r\n", "[device]\r\nname = \"\"\"\r\na\r\n\"\"\"\r\n");
    }

    #[test]
    fn what_is_not_toml_is_refused() {
        assert!(format("device.toml", "[device\n").is_err_and(|(faults, _)| faults.has_errors()));
    }
}
