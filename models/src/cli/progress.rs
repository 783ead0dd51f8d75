//! A progress bar on a terminal, nothing in a pipe.

use indicatif::{ProgressBar, ProgressStyle};

const N_PARTS: u64 = 1000;

/// A bar that is shown when standard error is a terminal.
pub struct Progress(ProgressBar);

impl Progress {
    pub fn new() -> Self {
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}");
        let bar = ProgressBar::new(N_PARTS);
        Self(match style {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        })
    }

    /// Shows the fraction that is done.
    pub fn tell(&self, fraction: f64) {
        self.0.set_position((fraction * N_PARTS as f64) as u64);
    }

    /// Shows what is being done.
    pub fn tell_part(&self, part: &str) {
        self.0.set_message(part.to_owned());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
