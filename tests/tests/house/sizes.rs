//! How long files and functions may be.

use crate::Fault;
use crate::code::{Code, closing};

const LINES_OF_A_FILE: usize = 300;
const LINES_OF_A_TEST: usize = 600;
const LINES_OF_A_FUNCTION: usize = 60;

/// What is too long in a file.
pub(crate) fn too_long(code: &Code) -> Vec<Fault> {
    let mut faults: Vec<Fault> = file(code, LINES_OF_A_FILE).into_iter().collect();
    let tokens = code.tokens();
    for pair in tokens.windows(2) {
        let [("fn", start), (name, behind)] = pair else { continue };
        let Some(end) = end_of_function(code, *behind) else { continue };
        if code.line(end) - code.line(*start) >= LINES_OF_A_FUNCTION {
            let what = format!("`{name}` is too long a function");
            faults.push(Fault { file: code.path.clone(), line: code.line(*start), what });
        }
    }
    faults
}

/// That a file of tests is too long, if it is.
pub(crate) fn too_long_a_test(code: &Code) -> Option<Fault> {
    file(code, LINES_OF_A_TEST)
}

fn file(code: &Code, limit: usize) -> Option<Fault> {
    let lines = code.text.lines().count();
    let what = "is too long a file".to_owned();
    (lines > limit).then(|| Fault { file: code.path.clone(), line: lines, what })
}

/// Where the body of a function ends, if it has one.
fn end_of_function(code: &Code, from: usize) -> Option<usize> {
    let bytes = code.text.as_bytes();
    let mut place = from;
    loop {
        match bytes.get(place)? {
            b'(' | b'[' => place = closing(bytes, place),
            b'{' => return Some(closing(bytes, place)),
            b';' => return None,
            _ => {}
        }
        place += 1;
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn what_is_too_long_is_found() {
        let function = |lines: usize| {
            format!("fn f(a: [u8; 2]) -> u8 {{{}}}\ntrait T {{ fn g(); }}\n", "\n".repeat(lines - 1))
        };
        let found = |text: &str| too_long(&Code::new(Path::new("a.rs"), text));
        assert_eq!(found(&function(LINES_OF_A_FUNCTION)), []);
        let faults = found(&format!("\n{}", function(LINES_OF_A_FUNCTION + 1)));
        assert_eq!(
            faults.iter().map(Fault::to_string).collect::<Vec<_>>(),
            ["a.rs:2: `f` is too long a function"]
        );
        assert_eq!(found(&"\n".repeat(LINES_OF_A_FILE)), []);
        assert_eq!(found(&"\n".repeat(LINES_OF_A_FILE + 1)).len(), 1);
    }
}
