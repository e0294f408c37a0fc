use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Assumption, Device};
use crate::source::{Value, parts};
use crate::text::near::near;

rule! {
    /// An assumption is about what stands beside it, in the same table or for it in a table around. One of a key that is
    /// not there is listed as if something had been assumed, and the key that was meant counts as stated by the source.
    ///
    /// ## Fires
    /// ```toml
    /// [leds.run]
    /// name = "RUN"
    /// colour = "green"
    /// assumed = { color = "the photograph shows it so" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [leds.run]
    /// name = "RUN"
    /// colour = "green"
    /// assumed = { colour = "the photograph shows it so" }
    /// ```
    pub(super) static RULE = "idle-assumption", Facts, Warning, "what is assumed is not stated";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for assumption in device.assumptions.iter().filter(|it| it.value.is_none()) {
        if let Some(key) = &assumption.key {
            report.push(assumption.at.clone(), finding(assumption, key));
        }
    }
}

fn finding(assumption: &Assumption, key: &str) -> Diagnostic {
    let known = assumption.keys.iter().map(String::as_str);
    let stated = assumption.origin.table().members.iter().map(|member| &*member.key.name);
    let stated: Vec<&str> = stated.filter(|key| !matches!(*key, "assumed" | "source")).collect();
    let first = parts(key).next().unwrap_or(key);
    let is_known = known.clone().any(|known| known == first);
    let (message, label, help) = if is_known {
        (
            "is not stated",
            "not stated here",
            format!("write `{key} = ...` beside it, or take the assumption out"),
        )
    } else {
        ("is no key of its table", "not a key of this table", "name the key that is assumed".to_owned())
    };
    let at = assumption.origin.node("assumed").and_then(|assumed| match &assumed.value {
        Value::Table(reasons) => reasons.get(key).map(|member| member.key.at),
        _ => None,
    });
    let at = at.unwrap_or(assumption.origin.header());
    let diagnostic = Diagnostic::new(&RULE, format!("`{key}` is assumed, but {message}"), at, label);
    let meant = if is_known { None } else { near(key, stated.into_iter().chain(known)) };
    match meant {
        Some(meant) => diagnostic.fix(format!("did you mean `{meant}`?"), at, meant),
        None => diagnostic.help(help),
    }
}
