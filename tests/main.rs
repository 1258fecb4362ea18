//! The whole system: one module a subject.

mod bot;
mod check;
mod command_line;
mod demos;
mod golden;
mod picture;
mod plot;
mod recording;
mod rules;
mod still;
mod techniques;
mod tidy;
