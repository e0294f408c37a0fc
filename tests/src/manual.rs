//! What the manuals of the devices print, as tables that were taken from them independently of the descriptions in
//! `devices`: the yardstick for those descriptions.
//!
//! The tables of a device lie in `manual/<device>/*.tsv`, their row types in the module of the same name, so that
//! `rows::<s700::Object>()` reads the objects of the S700. They hold what is printed, faults included: a description
//! that departs from them needs an erratum or an assumption. Numbers and names are the manual's, other cells are our
//! own words.

mod cell;
mod table;

pub mod c887;
pub mod pmc_sc6;
pub mod s700;

pub use cell::{
    Access, Axes, AxisLetter, Brake, Cell, Direction, Edge, ErrorKind, Input, Member, Pattern, Sub, Word,
};
pub use table::{Cells, Row, rows};
