use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{AxisUnit, Device, Dimension, SYMBOLS, Section, Symbol, Unit, dimensions};
use crate::source::Value;

rule! {
    /// What is measured and the unit it is measured in say the same thing twice. Where they disagree, generated code
    /// has a type for the symbol, and people read the quantity: one of them is wrong. Symbols of a device's own, such as
    /// `increments`, and parts, such as `%`, can measure anything.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2001]
    /// name = "Ramp time"
    /// type = "UINT16"
    /// unit = "ramp"
    ///
    /// [units.ramp]
    /// quantity = "time"
    /// symbol = "mm"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2001]
    /// name = "Ramp time"
    /// type = "UINT16"
    /// unit = "ramp"
    ///
    /// [units.ramp]
    /// quantity = "time"
    /// symbol = "ms"
    /// ```
    pub(super) static RULE = "contradicted-quantity", Values, Warning, "a unit's symbol measures another quantity";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for unit in &device.units {
        let Some(allowed) = dimensions(&unit.quantity) else { continue };
        let measured = |axis: &AxisUnit| Symbol::find(&axis.symbol);
        let wrong =
            |symbol: &&Symbol| symbol.dimension != Dimension::Ratio && !allowed.contains(&symbol.dimension);
        if let Some(symbol) = unit.axes.iter().filter_map(measured).find(wrong) {
            judge(unit, symbol, allowed, report);
        }
    }
}

fn judge(unit: &Unit, symbol: &Symbol, allowed: &[Dimension], report: &mut Report) {
    let message = format!("a {} is not measured in `{}`", unit.quantity, symbol.text);
    let shared = unit.origin.node("symbol").map(|node| &node.value);
    let is_shared = matches!(shared, Some(Value::String(text)) if **text == *symbol.text);
    let at = unit.origin.value(if is_shared { "symbol" } else { "per-axis" });
    let fitting = SYMBOLS.iter().filter(|symbol| allowed.contains(&symbol.dimension));
    let fitting: Vec<String> = fitting.map(|symbol| format!("`{}`", symbol.text)).collect();
    let mut diagnostic = Diagnostic::new(&RULE, message, at, "measures something else")
        .label(unit.origin.value("quantity"), "what it should measure");
    if !fitting.is_empty() {
        diagnostic =
            diagnostic.help(format!("a {} is measured in one of {}", unit.quantity, lookup::list(&fitting)));
    }
    report.push(Section::Units.at(&unit.id), diagnostic);
}
