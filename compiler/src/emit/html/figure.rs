//! Pictures: SVG and HTML that need no script.

mod bits;
mod lights;
mod machine;
mod memory;

pub(super) use machine::svg as machine;
use minijinja::HtmlEscape;

use crate::emit::markdown::Picture;

/// A picture.
pub(super) fn picture(picture: &Picture) -> String {
    match picture {
        Picture::Word(count, parts) => bits::word(*count, parts),
        Picture::Bytes(count, parts) => bits::bytes(*count, parts),
        Picture::Memory(areas) => memory::svg(areas),
        Picture::Lights(lights) => lights::list(lights),
    }
}

/// How wide a character of the small print of pictures is at most, in tenths.
const CHARACTER: usize = 64;

/// A text as it fits a width, cut if it has to be.
fn fitting(text: &str, width: usize) -> String {
    let most = width * 10 / CHARACTER;
    match text.chars().count() {
        count if count <= most => HtmlEscape(text).to_string(),
        _ if most < 3 => String::new(),
        _ => {
            let cut: String = text.chars().take(most - 1).collect();
            format!("{}…", HtmlEscape(cut.trim_end()))
        }
    }
}

/// The beginning of a picture that is so large, and what it is called by those who do not see it.
fn begin(width: usize, height: usize, class: &str, title: &str) -> String {
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" role=\"img\" class=\"{class}\"><title>{}</title>\n",
        HtmlEscape(title)
    )
}
