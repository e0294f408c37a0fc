//! Descriptions that ask for much work by little text, each kind in any size.
//!
//! They are what a hostile user would write, or an unlucky one whose generator has gone wrong. devc has to answer each of
//! them in a time that grows with its size, or refuse it by a limit that the message names.

mod devices;
mod files;
mod machines;
mod values;

/// The files of a description: names and texts, `device.toml` first.
pub type Files = Vec<(String, String)>;

/// A kind of description.
pub struct Kind {
    /// What there is much of.
    pub name: &'static str,
    /// A description with so many of them.
    pub files: fn(usize) -> Files,
}

/// All kinds.
pub fn all() -> impl Iterator<Item = &'static Kind> {
    [files::KINDS, devices::KINDS, machines::KINDS, values::KINDS].into_iter().flatten()
}

/// What every description begins with.
pub const HEAD: &str = r#"profiles = ["ethercat", "cia402"]
[device]
name = "Generated"
vendor = "Example"
[identity]
vendor-id = 1
product-code = 2
revision = 3
[units]
increments = { quantity = "position", symbol = "inc" }
[objects.0x1000]
[objects.0x1018]
[objects.0x6040]
[objects.0x6041]
"#;

/// A description in one file.
pub fn one(text: impl AsRef<str>) -> Files {
    whole(HEAD.to_owned() + text.as_ref() + "\n")
}

/// A description in one file that begins otherwise.
pub fn whole(text: String) -> Files {
    vec![("device.toml".to_owned(), text)]
}

/// A text for each number, one after the other.
pub fn each(count: usize, text: impl Fn(usize) -> String) -> String {
    (0..count).map(text).collect()
}

/// The elements of an array or an inline table.
pub fn list(count: usize, text: impl Fn(usize) -> String) -> String {
    (0..count).map(text).collect::<Vec<_>>().join(",")
}

/// Objects of one byte from 0x2000 on, with something more in each.
pub fn objects(count: usize, more: impl Fn(usize) -> String) -> String {
    let object = |n| format!("[objects.0x{:04X}]\ntype=\"UINT8\"\naccess=\"rw\"\n{}\n", 0x2000 + n, more(n));
    each(count.min(0xE000), object)
}
