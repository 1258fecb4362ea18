//! Style as tests: who may name whom, how long files and functions may be, and that the documents are true.

mod code;
mod functions;
mod names;
mod papers;
mod rooms;
mod tree;
