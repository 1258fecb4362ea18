//! The whole system: one module a subject.

mod bot;
mod check;
mod recording;
mod tidy;
