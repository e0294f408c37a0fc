//! `devc explain`

use std::path::Path;

use clap::Args;
use devc::explain::{Unknown, explain, explain_bytes, explain_description, explain_word};
use devc::model::Device;
use devc::source::{Disk, MAIN_FILE};
use devc::text::characters::harmless;

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Explain a rule, a kind of change, a profile, or what profiles and descriptions define.
///
/// A rule: why it matters, with an example that breaks it and one that keeps it. A profile: what a description can refer
/// to. An index, a code, an id or a name: what the profiles say of it, or the description whose folder stands in front. A
/// value of a word: the state, the command and the bits; the bytes of a PDO, an emergency or another message: their fields.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Explain {
    /// A rule, as in the brackets of `error[unknown-key]`; a profile; an index, a code or a name, which a profile or the
    /// folder of a description, and a word such as `mode` or `error` in front narrow.
    #[arg(required = true, value_name = "WORD", allow_negative_numbers = true)]
    words: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  devc explain unknown-key          a rule
  devc explain cia402               a profile
  devc explain 0x6064               an object, an error or an AL status code
  devc explain cia402 0x60FE:01     an entry of an object
  devc explain target position      a thing by its name
  devc explain mode 8               one of several things with this number
  devc explain cia402 errors        all of a kind
  devc explain devices/s700 0x2000  what a description says of an object
  devc explain devices/s700 status 0x0637
                                    what the bits of a word mean for a drive
  devc explain devices/s700 0x1B01 37 06 10 27 00 00
                                    what the bytes of a PDO mean for it
  devc explain devices/s700 emcy 10 23 02 00 00 00 00 00
                                    what an emergency says
  devc explain abort 0x06040041     why an SDO transfer ended";

impl Explain {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let answer = self.of_description().unwrap_or_else(|| explain(&self.words));
        let answer = answer.map_err(|unknown| self.failure(&unknown))?;
        report.output(&format!("{}\n", harmless(&answer)));
        Ok(Outcome::Clean)
    }

    /// What a description says, if its folder stands in front.
    fn of_description(&self) -> Option<Result<String, Unknown>> {
        let (first, words) = self.words.split_first().filter(|(_, words)| !words.is_empty())?;
        let path = Path::new(first);
        path.join(MAIN_FILE).is_file().then_some(())?;
        let decoded = bits(path, words).or_else(|| bytes(path, words)).map(Ok);
        decoded.or_else(|| explain_description(&Disk, path, words))
    }

    fn failure(&self, Unknown { near }: &Unknown) -> Failure {
        let names: Vec<String> = near.iter().map(|name| format!("`{name}`")).collect();
        let help = match names.split_last() {
            None => "`devc rules` lists all rules, `devc explain cia402` what is in that profile".to_owned(),
            Some((only, [])) => format!("did you mean {only}?"),
            Some((last, others)) => format!("did you mean {} or {last}?", others.join(", ")),
        };
        Failure::new(format!("nothing is known of `{}`", self.words.join(" "))).help(help)
    }
}

/// What a value of a word means for a drive, and for each member of a family for which it means something else.
fn bits(path: &Path, words: &[String]) -> Option<String> {
    let [word, value] = words else { return None };
    let digits = value.strip_prefix("0x");
    let value = digits.map_or_else(|| value.parse().ok(), |digits| u64::from_str_radix(digits, 16).ok())?;
    of_members(path, |device| explain_word(device, word, value))
}

/// What bytes mean for a drive: those of a PDO, an emergency or another message.
fn bytes(path: &Path, words: &[String]) -> Option<String> {
    let tokens: Vec<&str> = words.iter().flat_map(|word| word.split_whitespace()).collect();
    let byte = |token: &&str| (token.len() == 2).then(|| u8::from_str_radix(token, 16).ok()).flatten();
    let count = tokens.iter().rev().take_while(|token| byte(token).is_some()).count();
    let (what, bytes) = tokens.split_at_checked(tokens.len().checked_sub(count)?)?;
    if what.is_empty() || bytes.is_empty() {
        return None;
    }
    let (what, bytes) = (what.join(" "), bytes.iter().filter_map(byte).collect::<Vec<u8>>());
    of_members(path, |device| explain_bytes(device, &what, &bytes))
}

/// What is said of a drive, and of each member of a family of which something else is said.
fn of_members(path: &Path, explain: impl Fn(&Device) -> Option<String>) -> Option<String> {
    let compilation = devc::compile(&Disk, path);
    let mut answers: Vec<String> = Vec::new();
    for device in &compilation.family.as_ref()?.members {
        let answer = explain(device)?;
        let same = |other: &String| {
            other.split_once('\n').map(|(_, bits)| bits) == answer.split_once('\n').map(|(_, bits)| bits)
        };
        if !answers.iter().any(same) {
            answers.push(answer);
        }
    }
    Some(answers.join("\n\n"))
}
