use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Dimension, SYMBOLS, Section, Symbol, dimensions};
use crate::source::Value;

rule! {
    /// A unit whose symbol is not known counts steps of the device's own. A known one in other letters, as `RPM` or `um`, looks
    /// the same to people, but generated code does not convert its values any longer. A known quantity with a slip in it, as
    /// `positon`, is measured in anything.
    ///
    /// ## Fires
    /// ```toml
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "RPM"
    /// raw-per-unit = 100
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// unit = "speed"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 100
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// unit = "speed"
    /// ```
    pub(super) static RULE = "misspelt-symbol", Values, Warning, "the symbol or the quantity of a unit is not written as it is known";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for unit in &device.units {
        let quantity = Some(&*unit.quantity).filter(|quantity| dimensions(quantity).is_none());
        if let Some(meant) = quantity.and_then(Dimension::quantity_meant) {
            let message = format!("the quantity `{}` of `{}` is not known", unit.quantity, unit.id);
            let at = unit.origin.value("quantity");
            let diagnostic = Diagnostic::new(&RULE, message, at, "is not held against the symbol");
            let fix = format!("did you mean `{meant}`?");
            report.push(Section::Units.at(&unit.id), diagnostic.fix(fix, at, format!("\"{meant}\"")));
        }
        for symbol in unit.axes.iter().map(|axis| &*axis.symbol).filter(|it| Symbol::find(it).is_none()) {
            let Some(meant) = meant(symbol) else { continue };
            let shared = unit
                .origin
                .node("symbol")
                .filter(|node| matches!(&node.value, Value::String(text) if **text == *symbol));
            let at = unit.origin.value(if shared.is_some() { "symbol" } else { "per-axis" });
            let message = format!("the symbol `{symbol}` of `{}` is not known", unit.id);
            let diagnostic = Diagnostic::new(&RULE, message, at, "counts steps of the device's own")
                .help(format!("did you mean `{meant}`?"));
            report.push(Section::Units.at(&unit.id), diagnostic);
        }
    }
}

/// The only known symbol that is the same but for how it is written; one letter is too little to tell, and `MN` is no `mN`.
fn meant(symbol: &str) -> Option<&'static str> {
    let is_other_prefix =
        symbol.strip_prefix('M').is_some_and(|rest| Symbol::find(&format!("m{rest}")).is_some());
    if symbol.chars().count() < 2 || is_other_prefix {
        return None;
    }
    let key = plain(symbol);
    let mut same = SYMBOLS.iter().filter(|known| plain(known.text) == key);
    let meant = same.next()?;
    same.next().is_none().then_some(meant.text)
}

/// A symbol with small letters, and without the signs that keyboards lack.
fn plain(symbol: &str) -> String {
    let signs = [("µ", "u"), ("μ", "u"), ("²", "2"), ("^", ""), (" ", ""), ("sec", "s"), ("u/min", "rpm")];
    let small = symbol.to_lowercase();
    let small = if small == "1/min" || small == "min-1" { "rpm".to_owned() } else { small };
    signs.iter().fold(small, |text, (sign, plain)| text.replace(sign, plain))
}
