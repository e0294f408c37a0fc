//! Lines as wide as the repository's: the printer breaks earlier, and lists to one item a line.

/// Columns of a line.
const WIDTH: usize = 110;

/// Puts on one line what was broken and fits, and fills lists that do not fit.
pub(super) fn widen(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in fill_patterns(text) {
        let closes = line.trim_start().starts_with([')', ']', '}']);
        lines.push(line);
        if closes {
            close(&mut lines);
        }
    }
    lines.iter().flat_map(|line| [line.as_str(), "\n"]).collect()
}

/// Puts the group that the last line closes on one line, if it is a list.
fn close(lines: &mut Vec<String>) {
    let Some(closer) = lines.last().cloned() else { return };
    let indent = indentation(&closer);
    let before = lines.len().saturating_sub(1);
    let inner = lines.iter().take(before).rev().take_while(|line| indentation(line) > indent).count();
    let start = before.saturating_sub(inner);
    let Some(opener) = start.checked_sub(1).and_then(|place| lines.get(place)).cloned() else { return };
    let items: Vec<String> =
        lines.iter().take(before).skip(start).map(|line| line.trim().to_owned()).collect();
    if indentation(&opener) != indent || !is_list(&opener, &closer, &items, lines.get(start)) {
        return;
    }
    let is_struct = closer.trim_start().starts_with('}') && !opener.trim_start().starts_with("use ");
    let gap = if is_struct { " " } else { "" };
    let list = items.join(" ");
    let joined = format!("{opener}{gap}{}{gap}{}", list.trim_end_matches(','), closer.trim_start());
    if joined.chars().count() <= WIDTH {
        lines.truncate(start.saturating_sub(1));
        lines.push(joined);
    } else if items.len() > 6 && items.iter().all(|item| is_word(item)) {
        lines.truncate(start);
        fill(lines, &items, indent + 4);
        lines.push(closer);
    }
}

/// Whether each line is an item of a list: a block has statements or arms, a declaration has documentation.
fn is_list(opener: &str, closer: &str, items: &[String], first: Option<&String>) -> bool {
    let closes = match closer.trim_start().chars().next() {
        Some(')') => opener.ends_with('('),
        Some(']') => opener.ends_with('['),
        Some('}') => opener.ends_with('{') && items.iter().all(|item| item.ends_with(',')),
        _ => false,
    };
    let depth = first.map_or(0, |line| indentation(line));
    let is_item = |item: &String| {
        !item.is_empty()
            && !item.contains("//")
            && !item.contains("=>")
            && !item.ends_with([';', '{', '(', '['])
    };
    closes
        && depth == indentation(opener) + 4
        && !items.is_empty()
        && items.iter().all(is_item)
        && items.split_last().is_some_and(|(_, rest)| rest.iter().all(|item| item.ends_with(',')))
}

/// Fills the patterns of arrays, which the printer breaks without indenting them.
fn fill_patterns(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut is_open = false;
    for line in text.lines() {
        let item = line.trim();
        match lines.last_mut().filter(|_| is_open) {
            Some(last) if item.starts_with(']') => *last = format!("{}{item}", last.trim_end_matches(',')),
            Some(last) if last.len() + 1 + item.len() <= WIDTH => {
                last.push(' ');
                last.push_str(item);
            }
            Some(_) => lines.push(format!("{} {item}", " ".repeat(indentation(line)))),
            None => lines.push(line.to_owned()),
        }
        is_open = if is_open { !item.contains(']') } else { begins_pattern(item) };
    }
    lines
}

/// Whether the first item stands behind the bracket; in lists that are broken it has a line of its own.
fn begins_pattern(line: &str) -> bool {
    line.rsplit_once('[').is_some_and(|(_, item)| item.ends_with(',') && is_word(item))
}

/// A variable or a number.
fn is_word(item: &str) -> bool {
    item.trim_end_matches(',').chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

fn fill(lines: &mut Vec<String>, items: &[String], indent: usize) {
    let mut line = " ".repeat(indent);
    for item in items {
        if line.trim().is_empty() {
            line.push_str(item);
        } else if line.len() + 1 + item.len() <= WIDTH {
            line.push(' ');
            line.push_str(item);
        } else {
            lines.push(std::mem::replace(&mut line, format!("{}{item}", " ".repeat(indent))));
        }
    }
    lines.push(line);
}

fn indentation(line: &str) -> usize {
    if line.is_empty() { usize::MAX } else { line.len() - line.trim_start().len() }
}

#[cfg(test)]
mod tests {
    use super::widen;

    #[test]
    fn groups_that_fit_become_a_line() {
        let text =
            "    let x = f(\n        a,\n        &[\n            1,\n            2,\n        ],\n    );\n";
        assert_eq!(widen(text), "    let x = f(a, &[1, 2]);\n");
        let text = "A {\n    b: 1,\n    c: 2,\n};\n";
        assert_eq!(widen(text), "A { b: 1, c: 2 };\n");
    }

    #[test]
    fn blocks_arms_and_documented_fields_stay() {
        for text in [
            "fn f() {\n    g()\n}\n",
            "match x {\n    1 => 2,\n    _ => 3,\n}\n",
            "pub struct A {\n    /// b\n    pub b: u8,\n}\n",
            "impl A {\n    const B: u8 = 1;\n    const C: u8 = 1;\n}\n",
        ] {
            assert_eq!(widen(text), text);
        }
    }

    #[test]
    fn long_lists_of_words_are_filled() {
        let items: String = (0..60).map(|n| format!("    b{n},\n")).collect();
        let filled = widen(&format!("let [\n{items}] = x;\n"));
        assert!(filled.lines().count() < 8, "{filled}");
        assert!(filled.lines().all(|line| line.len() <= super::WIDTH), "{filled}");
    }
}
