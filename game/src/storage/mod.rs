//! Files: where tables, demos and recordings lie, how they are read and written.
//!
//! The rooms below take texts and bytes. This room turns paths into those, and what goes wrong into a sentence that
//! names the file.

pub mod assets;
mod file_failure;
mod late_file;
pub mod library;
mod limited_read;
pub mod new_file;
pub mod picture_file;
mod png_file;
pub mod recording_file;
pub mod recordings;
mod retention;
mod table_search;
pub mod tables;
#[cfg(test)]
mod tests;
pub mod text_file;
mod watch;

pub use file_failure::{because, file_failure, folder_failure};
pub use png_file::{check_place, save_png};
pub use watch::FileWatch;
