//! The reference as lines, each with what a person sees it under.

/// The lines before the lists of what is not stated, and those of the lists.
pub(super) struct Text<'t> {
    body: Vec<Line<'t>>,
    /// Each without markup and as it is.
    lists: Vec<(String, &'t str)>,
}

/// A line.
#[derive(Debug, Clone, Default)]
pub(super) struct Line<'t> {
    pub(super) chapter: &'t str,
    /// The headings below that of the chapter, and the row that this one continues.
    under: Vec<(usize, &'t str)>,
    pub(super) text: &'t str,
    /// Which row of its table it is, from 1.
    pub(super) row: usize,
}

impl<'t> Text<'t> {
    pub(super) fn read(markdown: &'t str) -> Self {
        let sources = markdown.find("</a>Sources\n").expect("a chapter of sources");
        let lists = markdown[sources..].find("\n### ").map_or(markdown.len(), |lists| sources + lists);
        let (body, lists) = markdown.split_at(lists);
        let (mut line, mut lines) = (Line::default(), Vec::new());
        for text in body.lines() {
            line.text = text;
            line.row = if text.starts_with('|') { line.row + 1 } else { 0 };
            let level = text.bytes().take_while(|byte| *byte == b'#').count();
            let title = text.trim_start_matches('#').rsplit("</a>").next().unwrap_or_default().trim();
            match level {
                0 => {}
                1 | 2 => (line.chapter, line.under) = (title, Vec::new()),
                _ => {
                    line.under.retain(|(other, _)| *other < level);
                    line.under.push((level, title));
                }
            }
            if text.starts_with('|') && !text.starts_with("| &emsp;") {
                line.under.retain(|(other, _)| *other < ROW);
                line.under.push((ROW, text));
            }
            lines.push(line.clone());
        }
        let lists = lists.lines().filter(|line| line.contains("<a id=\""));
        Self { body: lines, lists: lists.map(|line| (plain(line), line)).collect() }
    }

    /// The place to which links about a thing have to lead.
    pub(super) fn anchor(&self, at: &str, rule: Option<&str>) -> String {
        let titled = |(plain, _): &&(String, &str)| match rule {
            Some(rule) => plain.starts_with('-') && plain.contains(&format!("**{at}** ({rule})")),
            None => plain.starts_with(&format!("| {at} |")),
        };
        let (_, line) = self.lists.iter().find(titled).unwrap_or_else(|| panic!("{at} is not listed"));
        crate::between(line, "<a id=\"", '"').next().expect("an anchor").to_owned()
    }

    /// The lines that link to a place.
    pub(super) fn lines_to(&self, anchor: &str) -> impl Iterator<Item = &Line<'t>> {
        let link = format!("](#{anchor})");
        self.body.iter().filter(move |line| line.text.contains(&link))
    }
}

/// Deeper than any heading.
const ROW: usize = 9;

impl Line<'_> {
    /// The line and what it is under, without markup.
    pub(super) fn all(&self) -> String {
        let under = self.under.iter().map(|(_, text)| *text);
        under.chain([self.text]).map(plain).collect::<Vec<_>>().join("\n")
    }
}

/// A line without anchors, links, code marks and escapes.
fn plain(line: &str) -> String {
    let mut out = String::new();
    for (number, piece) in line.split("<a id=\"").enumerate() {
        out += if number == 0 { piece } else { piece.split_once("</a>").map_or("", |(_, rest)| rest) };
    }
    let mut pieces = out.split("](");
    let first = pieces.next().unwrap_or_default().to_owned();
    let rest = pieces.map(|piece| piece.split_once(')').map_or("", |(_, rest)| rest));
    rest.fold(first, |line, piece| line + piece).replace(['`', '[', '\\'], "")
}
