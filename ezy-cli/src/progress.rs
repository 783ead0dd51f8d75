//! A progress bar on a terminal, nothing in a pipe.

use indicatif::{ProgressBar, ProgressStyle};

const N_PARTS: u64 = 1000;

/// A progress bar that is shown when standard error is a terminal.
#[derive(Debug)]
pub struct Progress(ProgressBar);

impl Default for Progress {
    fn default() -> Self {
        Self::new()
    }
}

impl Progress {
    /// A bar at zero.
    pub fn new() -> Self {
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {eta} left  {msg}");
        let bar = ProgressBar::new(N_PARTS);
        Self(match style {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        })
    }

    /// A bar of `n` cases, with those done, their rate and the time that is left.
    pub(super) fn of_cases(n: u64) -> Self {
        let style = ProgressStyle::with_template("{bar:30} {human_pos} of {human_len}  {per_sec}  {eta} left  {msg}");
        let bar = ProgressBar::new(n);
        Self(match style {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        })
    }

    /// Shows how many cases of how many are done.
    pub(super) fn tell_cases(&self, n_done: u64, n: u64) {
        self.0.set_length(n);
        self.0.set_position(n_done);
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
