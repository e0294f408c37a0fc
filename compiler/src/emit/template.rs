//! Templates: the layout of an output, where that is easier to see in the output's own language.

use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, Error, UndefinedBehavior, Value};

use crate::text::characters::harmless;

/// Where a name that is not there is a mistake, and lines that only steer leave nothing behind.
pub(super) fn environment() -> Result<Environment<'static>, Error> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    environment.add_filter("hex", |number: u64, digits: usize| format!("0x{number:0digits$X}"));
    environment.add_filter("digits", |number: u64, digits: usize| format!("{number:0digits$X}"));
    Ok(environment)
}

/// What a template makes of a context, with filters of the language it is in.
pub(super) fn render(
    name: &str,
    template: &str,
    filters: impl FnOnce(&mut Environment<'static>),
    context: Value,
) -> String {
    let rendered = environment().and_then(|mut environment| {
        filters(&mut environment);
        environment.render_named_str(name, template, context)
    });
    let text = rendered.unwrap_or_else(|error| format!("devc could not print this: {error:#}"));
    harmless(&text).into_owned() + "\n"
}
