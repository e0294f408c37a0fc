//! How many messages of a rule are said.

use std::num::NonZero;

use clap::Args;
use devc::Compilation;

/// How many a person reads before the rule or the description is mended: the rest mostly says the same.
const READ: usize = 20;

#[derive(Debug, Default, Args)]
pub(super) struct Limit {
    /// Say at most so many messages of a rule, and count the others [default: 20 for people, all for programs].
    #[arg(long, value_name = "COUNT")]
    limit: Option<NonZero<usize>>,
}

impl Limit {
    /// Cuts what is to be read by people.
    pub(super) fn cut(&self, compilation: &mut Compilation) {
        compilation.diagnostics.cut(self.limit.map_or(READ, NonZero::get));
    }

    /// Cuts what is to be read by programs, which is all of it unless something else is asked for.
    pub(super) fn cut_for_programs(&self, compilation: &mut Compilation) {
        if let Some(limit) = self.limit {
            compilation.diagnostics.cut(limit.get());
        }
    }
}
