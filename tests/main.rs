//! The whole system: one module a subject.

mod bot;
mod recording;
mod tidy;
