//! The Rust that devc generates: as text and through the derive, against the manual, and as a user's build sees it.

#![cfg(test)]

mod access;
mod bounded;
mod c887;
mod carried;
mod complete;
mod conditions;
mod dictionary;
mod family;
mod geared;
mod images;
mod information;
mod mapped;
mod memory;
mod own;
mod pdos;
mod played;
mod refusals;
mod same;
mod units;
mod widths;
