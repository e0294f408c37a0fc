//! FoE, as far as a drive has it that keeps no files and takes no new firmware: each request gets the error that says so
//! (ETG.1000.6, FoE).

use devc_runtime::coe::Protocol;

/// Mailbox header, opcode and code, which stand before the text of an error.
const HEAD: usize = 12;

/// Opcodes of a message.
const READ: u8 = 1;
const WRITE: u8 = 2;
const ERROR: u8 = 5;

/// There is no such file.
const NOT_FOUND: u32 = 0x8001;
/// The file cannot be written.
const ACCESS_DENIED: u32 = 0x8002;
/// The message has no place here.
const ILLEGAL: u32 = 0x8004;

/// Answers what is in a message, behind the mailbox header: writes the answer and tells its length. An error of the master's has
/// no answer; a message without an opcode is none, and there is nothing to be said in its own terms.
pub(super) fn refuse(content: &[u8], counter: u8, answer: &mut [u8]) -> Option<usize> {
    let (code, text) = match *content.first()? {
        READ => (NOT_FOUND, "there are no files"),
        WRITE => (ACCESS_DENIED, "a virtual drive takes no files"),
        ERROR => return Some(0),
        _ => (ILLEGAL, "no file is on its way"),
    };
    // a mailbox that is too short for the text gets what fits
    let text = text.as_bytes();
    let text = text.get(..text.len().min(answer.len().checked_sub(HEAD)?))?;
    let [low, high] = u16::try_from(text.len() + 6).ok()?.to_le_bytes();
    let head = [low, high, 0, 0, 0, counter << 4 | Protocol::FOE.0, ERROR, 0];
    let message = [&head, code.to_le_bytes().as_slice(), text].concat();
    answer.get_mut(..message.len())?.copy_from_slice(&message);
    Some(message.len())
}
