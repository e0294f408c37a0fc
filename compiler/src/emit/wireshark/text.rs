//! Texts and tables as Lua holds them.

use std::fmt::Write;

use minijinja::{Environment, Error, Value};

use crate::text::characters::line;

/// What the template needs.
pub(super) fn filters(environment: &mut Environment<'static>) {
    environment.add_filter("line", |text: String| line(&text).into_owned());
    environment.add_filter("string", |text: String| string(&text));
    environment.add_filter("indices", |indices: Vec<u64>| -> String {
        let indices: Vec<String> = indices.iter().map(|index| format!("0x{index:04X}")).collect();
        format!("{{ {} }}", indices.join(", "))
    });
    environment.add_filter("pdo", pdo);
    environment.add_filter("meanings", |values: Value| meanings(&values));
    environment.add_filter("bits", bits);
}

/// What values mean: the first and the last of each, and a name.
fn meanings(values: &Value) -> Result<String, Error> {
    let mut text = String::from("{ ");
    for value in values.try_iter()? {
        let name = value.get_item(&Value::from(2))?;
        let (first, last) = (value.get_item(&Value::from(0))?, value.get_item(&Value::from(1))?);
        // Writing to a String cannot fail.
        let _ = write!(text, "{{ {first}, {last}, {} }}, ", string(&name.to_string()));
    }
    Ok(text + "}")
}

/// Bits of a word: lowest and highest, filter and name, and what values mean.
fn bits(bits: &Value) -> Result<String, Error> {
    let text = |key: &str| bits.get_attr(key).map(|text| string(&text.to_string()));
    let (low, high) = (bits.get_attr("low")?, bits.get_attr("high")?);
    let mut said = format!("{{ {low}, {high}, {}, {}", text("filter")?, text("title")?);
    let values = bits.get_attr("values")?;
    if values.is_true() {
        let _ = write!(said, ", values = {}", meanings(&values)?);
    }
    Ok(said + " }")
}

/// A PDO: its name, then key and bits of each entry.
fn pdo(pdo: &Value) -> Result<String, Error> {
    let number = |value: &Value, key: &str| -> Result<u64, Error> { value.get_attr(key)?.try_into() };
    let mut text = format!("{{ {}", string(&pdo.get_attr("title")?.to_string()));
    for entry in pdo.get_attr("mapping")?.try_iter()? {
        let key = number(&entry, "index")? * 256 + number(&entry, "subindex")?;
        let key = if key == 0 { "0".to_owned() } else { format!("0x{key:06X}") };
        // Writing to a String cannot fail.
        let _ = write!(text, ", {key}, {}", number(&entry, "bits")?);
    }
    Ok(text + " }")
}

/// A text as a literal.
pub(super) fn string(text: &str) -> String {
    let mut literal = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => literal.extend(['\\', c]),
            _ if c.is_control() => _ = write!(literal, "\\{:03}", u32::from(c) & 0xFF),
            _ => literal.push(c),
        }
    }
    literal.push('"');
    literal
}

#[cfg(test)]
mod tests {
    use super::string;

    #[test]
    fn no_text_leaves_its_literal() {
        assert_eq!(string("\"µ\\\n"), "\"\\\"µ\\\\\\010\"");
    }
}
