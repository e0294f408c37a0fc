//! The command line of devc.

fn main() {}
