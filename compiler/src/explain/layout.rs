//! Text for a terminal.

/// The longest line.
const WIDTH: usize = 100;

/// A text in lines, all but the first of which begin with so many spaces; the first follows on `head`.
pub(super) fn hang(head: &str, text: &str, indent: usize) -> String {
    let mut out = head.to_owned();
    let mut column = head.chars().count();
    let mut begins = true;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if !begins && column + 1 + length > WIDTH {
            out.push('\n');
            out.push_str(&" ".repeat(indent));
            column = indent;
            begins = true;
        }
        if !begins {
            out.push(' ');
            column += 1;
        }
        out.push_str(word);
        column += length;
        begins = false;
    }
    out
}

/// A paragraph.
pub(super) fn paragraph(text: &str) -> String {
    hang("", text, 0)
}

/// Rows with their columns below each other, two spaces in; the last column may take several lines.
pub(super) fn columns(rows: &[Vec<String>]) -> Vec<String> {
    let widths: Vec<usize> = (0..rows.iter().map(Vec::len).max().unwrap_or(0))
        .map(|column| {
            let cells = rows.iter().filter(|row| column + 1 < row.len()).filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        })
        .collect();
    rows.iter().map(|row| line(row, &widths)).collect()
}

fn line(row: &[String], widths: &[usize]) -> String {
    let Some((last, before)) = row.split_last() else { return String::new() };
    let mut head = String::from("  ");
    for (cell, width) in before.iter().zip(widths) {
        head.push_str(cell);
        head.push_str(&" ".repeat(width.saturating_sub(cell.chars().count()) + 2));
    }
    let indent = head.chars().count();
    hang(&head, last, indent).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_broken_between_words() {
        let text = "word ".repeat(40);
        let broken = hang("  head  ", &text, 8);
        assert!(broken.lines().all(|line| line.chars().count() <= WIDTH), "{broken}");
        assert!(broken.lines().skip(1).all(|line| line.starts_with("        word")), "{broken}");
        assert_eq!(broken.split_whitespace().count(), 41);
    }

    #[test]
    fn columns_stand_below_each_other() {
        let rows = [vec!["a".to_owned(), "b".to_owned()], vec!["long".to_owned(), "c".to_owned()]];
        assert_eq!(columns(&rows), ["  a     b", "  long  c"]);
    }
}
