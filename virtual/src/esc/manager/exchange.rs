//! How the two sides of a sync manager take turns.

/// Who may access which buffer. One side writes, the other reads: which is the master's depends on the direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Exchange {
    /// One buffer: it is read before it is written again, so that no message is lost.
    Mailbox {
        /// Whether a message waits to be read.
        is_full: bool,
    },
    /// Three buffers, so that both sides can always go on: one is being written, one is being read, and the third has the
    /// latest data or is free.
    Buffered {
        writing: u8,
        reading: u8,
        third: u8,
        /// Whether the third is newer than the one that is read.
        is_fresh: bool,
        /// The one that was written last.
        latest: Option<u8>,
    },
}

impl Exchange {
    pub(super) const fn mailbox() -> Self {
        Self::Mailbox { is_full: false }
    }

    pub(super) const fn buffered() -> Self {
        Self::Buffered { writing: 0, reading: 2, third: 1, is_fresh: false, latest: None }
    }

    /// The buffer to be written; none while the mailbox is full.
    pub(super) const fn begin_write(self) -> Option<u8> {
        match self {
            Self::Mailbox { is_full: true } => None,
            Self::Mailbox { is_full: false } => Some(0),
            Self::Buffered { writing, .. } => Some(writing),
        }
    }

    /// The buffer is written.
    pub(super) const fn end_write(&mut self) {
        match self {
            Self::Mailbox { is_full } => *is_full = true,
            Self::Buffered { writing, third, is_fresh, latest, .. } => {
                (*latest, *is_fresh) = (Some(*writing), true);
                (*writing, *third) = (*third, *writing);
            }
        }
    }

    /// The buffer to be read; none while the mailbox is empty, or before anything was written.
    pub(super) const fn begin_read(&mut self) -> Option<u8> {
        match self {
            Self::Mailbox { is_full: true } => Some(0),
            Self::Mailbox { is_full: false } | Self::Buffered { latest: None, .. } => None,
            Self::Buffered { reading, third, is_fresh, .. } => {
                if *is_fresh {
                    (*reading, *third, *is_fresh) = (*third, *reading, false);
                }
                Some(*reading)
            }
        }
    }

    /// The buffer is read.
    pub(super) const fn end_read(&mut self) {
        if let Self::Mailbox { is_full } = self {
            *is_full = false;
        }
    }

    /// Bits 3 to 5 of the status: whether the mailbox is full, or which buffer was written last.
    pub(super) const fn status(self) -> u8 {
        match self {
            Self::Mailbox { is_full } => (is_full as u8) << 3,
            Self::Buffered { latest: Some(latest), .. } => latest << 4,
            Self::Buffered { latest: None, .. } => 0x30,
        }
    }

    /// How many times its length the area takes.
    pub(super) const fn buffers(self) -> u32 {
        match self {
            Self::Mailbox { .. } => 1,
            Self::Buffered { .. } => 3,
        }
    }
}
