//! What rules say of their examples.

use devc::diagnostic::{Group, Rule};
use devc::lint;

use crate::example::{compiled, example, messages};
use crate::rules;

/// What every rule says of its first example, to be read as a user would: a file a group.
#[test]
fn messages_are_as_reviewed() {
    for group in Group::ALL {
        let mut members: Vec<&Rule> = rules().filter(|rule| rule.group == group).collect();
        members.sort_unstable_by_key(|rule| rule.name);
        let examples = members.iter().filter_map(|rule| Some((rule.name, example(rule.docs, "Fires")?)));
        let messages = examples.flat_map(|(rule, example)| messages(rule, example));
        snapshot(group.name(), &messages.collect::<Vec<_>>().join("\n\n"));
    }
}

/// The name under which an erratum answers what each rule finds in its first example.
#[test]
fn findings_have_names_for_errata() {
    let names = lint::ALL.iter().filter_map(|lint| {
        let at = places(lint.rule.name, example(lint.rule.docs, "Fires")?)?;
        Some(format!("{}: {at}", lint.rule.name))
    });
    snapshot("names", &names.collect::<Vec<_>>().join("\n"));
}

/// Where a rule finds something, as it tells an erratum that names another place.
fn places(rule: &str, example: &str) -> Option<String> {
    let erratum = format!("rule = \"{rule}\"\nat = \"device\"\nsays = {{}}\nwhy = \"-\"\n");
    let (main, others) = example.split_once(" # file: ").unwrap_or((example, ""));
    let others = if others.is_empty() { String::new() } else { format!("# file: {others}") };
    let compilation = compiled(rule, &format!("{main}\n[[errata]]\n{erratum}{others}"));
    let idle = compilation.diagnostics.iter().find(|diagnostic| diagnostic.rule.name == "idle-erratum")?;
    let help = idle.helps.first()?;
    help.text.strip_prefix("it finds something at ").map(str::to_owned)
}

fn snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_omit_expression(true);
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| insta::assert_snapshot!(name, text));
}
