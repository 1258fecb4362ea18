//! The whole system: one module a subject.

mod bot;
mod check;
mod command_line;
mod demos;
mod fuzz_corpora;
mod golden;
mod picture;
mod plot;
mod recording;
mod recording_chunks;
mod recording_files;
mod render;
mod rules;
mod still;
mod techniques;
mod terminal;
mod tidy;
mod unreadable_files;
