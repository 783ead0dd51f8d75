//! Files that take their place when they are complete. Knows nothing of what is in them.

mod file;
mod folder;

pub use file::{OutputFile, write};
pub use folder::OutputFolder;
