//! The whole system: one module a subject.

mod recording;
mod tidy;
