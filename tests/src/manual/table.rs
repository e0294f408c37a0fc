//! Reading one table: a `#` line that names the place in the manual, a header line, then tab separated rows.

/// A table whose rows have the type that implements this; [`rows`](super::rows) reads it.
pub trait Row: Sized {
    /// Name of the file, for messages.
    const FILE: &'static str;
    /// Its whole text.
    const TEXT: &'static str;
    /// The columns its header has to name, in this order.
    const COLUMNS: &'static [&'static str];

    /// Takes one row out of its cells.
    ///
    /// # Errors
    ///
    /// The first cell that is missing or does not hold what its column promises.
    fn read(cells: &mut Cells) -> Result<Self, String>;
}

/// The cells of one row, taken from left to right.
#[derive(Debug)]
pub struct Cells {
    rest: std::str::Split<'static, char>,
}

impl Cells {
    /// Takes the next cell, which belongs to `column`.
    ///
    /// # Errors
    ///
    /// The row is too short, or the cell is not a `T`.
    pub fn take<T: super::Cell>(&mut self, column: &str) -> Result<T, String> {
        let cell = self.rest.next().ok_or_else(|| format!("column `{column}` is missing"))?;
        T::parse(cell).map_err(|fault| format!("column `{column}`: {fault}"))
    }
}

/// Reads every row of the table `R`.
///
/// # Errors
///
/// The first fault, with file and line: a header other than [`Row::COLUMNS`], a row with too few or too many
/// cells, or a cell that does not parse.
pub fn rows<R: Row>() -> Result<Vec<R>, String> {
    let mut lines = (1..).zip(R::TEXT.lines()).filter(|(_, line)| !line.starts_with('#'));
    let header: Vec<_> = lines.next().map(|(_, line)| line.split('\t').collect()).unwrap_or_default();
    if header != R::COLUMNS {
        return Err(format!("{}: columns are {header:?}, not {:?}", R::FILE, R::COLUMNS));
    }
    lines.map(|(number, line)| read(line).map_err(|fault| format!("{}:{number}: {fault}", R::FILE))).collect()
}

fn read<R: Row>(line: &'static str) -> Result<R, String> {
    let mut cells = Cells { rest: line.split('\t') };
    let row = R::read(&mut cells)?;
    match cells.rest.next() {
        Some(extra) => Err(format!("a cell too many: `{extra}`")),
        None => Ok(row),
    }
}

/// Declares row types: each a documented struct whose fields are the columns of the named file in the folder.
macro_rules! tables {
    ($folder:literal, $($(#[$meta:meta])* $name:ident in $file:literal {
        $($(#[$field_meta:meta])* $field:ident: $type:ty,)+
    })+) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub struct $name {
            $($(#[$field_meta])* pub $field: $type,)+
        }

        impl Row for $name {
            const FILE: &'static str = concat!($folder, "/", $file);
            const TEXT: &'static str = include_str!(concat!("../../manual/", $folder, "/", $file));
            const COLUMNS: &'static [&'static str] = &[$(stringify!($field)),+];

            fn read(cells: &mut Cells) -> Result<Self, String> {
                Ok(Self { $($field: cells.take(stringify!($field))?,)+ })
            }
        }
    )+};
}
pub(super) use tables;
