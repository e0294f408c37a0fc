//! The command line of devc.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
