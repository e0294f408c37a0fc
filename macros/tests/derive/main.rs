//! What a user sees who writes the derives rightly or wrongly.

#![cfg(test)]

mod built;
mod forms;
mod messages;
mod plain;
mod rebuild;
