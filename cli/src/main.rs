//! The command line of devc: one file a subcommand.
//!
//! It alone writes files, prints and looks at the clock; all else it asks of the libraries.

mod baseline;
mod build;
mod check;
mod completions;
mod diff;
mod draft;
mod edited;
mod existing;
mod explain;
mod fix;
mod fmt;
mod folders;
mod git;
mod import;
mod init;
mod levels;
mod limit;
#[cfg(feature = "lsp")]
mod lsp;
mod man;
mod names;
mod new;
mod outcome;
mod paths;
mod project;
mod report;
mod rules;
#[cfg(unix)]
mod run;
mod schema;
mod sums;
mod timings;
mod watch;
mod workers;
mod workplace;
mod write;

use std::process::ExitCode;

use clap::{ColorChoice, Parser, Subcommand};
use mimalloc::MiMalloc;

use report::Report;

/// Descriptions and outputs are many small texts: with the system's allocator a third of all work was to get memory and to
/// give it back.
#[global_allocator]
static MEMORY: MiMalloc = MiMalloc;

/// Compiles descriptions of EtherCAT drives into ESI XML, Markdown, JSON and Rust.
///
/// A description is a folder with a `device.toml`, which may include other TOML files of the folder.
#[derive(Debug, Parser)]
#[command(name = "devc", version, max_term_width = 100, after_help = EXAMPLES, after_long_help = LONG_EXAMPLES)]
struct Arguments {
    /// When to use colours.
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto")]
    color: ColorChoice,

    /// Say only what is wrong, not what was done.
    #[arg(long, short, global = true)]
    quiet: bool,

    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Build(build::Build),
    Check(check::Check),
    Completions(completions::Completions),
    Diff(diff::Diff),
    Explain(explain::Explain),
    Fmt(fmt::Fmt),
    Import(import::Import),
    Init(init::Init),
    #[cfg(feature = "lsp")]
    Lsp(lsp::Lsp),
    Man(man::Man),
    New(new::New),
    Rules(rules::Rules),
    #[cfg(unix)]
    Run(run::Run),
    Schema(schema::Schema),
}

const EXAMPLES: &str = "\
Examples:
  devc new devices/mydrive        begin a description
  devc build                      make the outputs of every description under devices/
  devc build devices/c887         make those of one
  devc check devices/c887         only say what is wrong with it
  devc fmt devices/c887           lay out its files
  devc diff main.. devices/c887   what has changed since a revision of git, and whom it breaks
  devc explain unknown-key        what a message means, with an example
  devc explain 0x6064             what the profiles say of an index, a code or a name
  devc import drive.xml           make a description of an ESI file
  devc run devices/c887 --interface eth1
                                  be the drive, for a master at a network interface";

const LONG_EXAMPLES: &str = "\
Examples:
  devc new devices/mydrive --axes 2 --mode csp,hm
                                  begin a description
  devc build                      make the outputs of every description under devices/
  devc build devices/c887         make those of one
  devc build --emit xml,md        make only the ESI and the Markdown
  devc build --check              say whether generated/ is up to date, and write nothing
  devc check devices/c887         only say what is wrong with it
  devc check --format sarif       say it for a machine
  devc check --baseline known.json --update-baseline
                                  start from what is known today, then leave out the second option
  devc fmt --check                say which files are not laid out, and write nothing
  devc diff old new --gate        whether the revision number announces what has changed
  devc diff main.. devices/c887   what has changed since a revision of git, and whom it breaks
  devc explain unknown-key        what a message means, with an example
  devc explain 0x6064             what the profiles say of an index, a code or a name
  devc import drive.xml           make a description of an ESI file
  devc import io.xml --device EL1008 --out devices/el1008
                                  of one device of several, into a folder
  devc run devices/c887 --interface eth1
                                  be the drive, for a master at a network interface
  devc run devices/c887 -i eth1 --fault X=0x7305@5s --trace c887.pcapng
                                  with a fault after five seconds, and all frames in a file

Exit codes:
  0  all is well; there may be warnings
  1  findings: errors in a description, or outputs that are not up to date
  2  devc could not run: bad arguments, no such description, an output that cannot be written";

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let report = Report::new(arguments.color, arguments.quiet);
    let outcome = match &arguments.command {
        Command::Build(build) => build.run(&report),
        Command::Check(check) => check.run(&report),
        Command::Completions(completions) => completions.run(&report),
        Command::Diff(diff) => diff.run(&report),
        Command::Explain(explain) => explain.run(&report),
        Command::Fmt(fmt) => fmt.run(&report),
        Command::Import(import) => import.run(&report),
        Command::Init(init) => init.run(&report),
        #[cfg(feature = "lsp")]
        Command::Lsp(lsp) => lsp.run(&report),
        Command::Man(man) => man.run(&report),
        Command::New(new) => new.run(&report),
        Command::Rules(rules) => rules.run(&report),
        #[cfg(unix)]
        Command::Run(run) => run.run(&report),
        Command::Schema(schema) => schema.run(&report),
    };
    report.end(outcome.unwrap_or_else(|failure| report.failure(&failure))).into()
}
