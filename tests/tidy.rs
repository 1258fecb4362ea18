//! Style as tests: who may name whom, how long files and functions may be, and that the documents are true.

mod code;
mod forbidden_names;
mod functions;
mod members;
mod papers;
mod rooms;
mod tree;
