//! Part of devc.
