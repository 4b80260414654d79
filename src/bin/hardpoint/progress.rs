//! A bar for what takes long.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A line on the terminal for what takes long and has no known end; nothing where stderr is no terminal.
pub struct Waiting(ProgressBar);

impl Waiting {
    /// With words that say what is done.
    pub fn for_end_of(words: String) -> Self {
        let style = ProgressStyle::with_template("{spinner} {msg}, {elapsed}");
        let bar = ProgressBar::new_spinner().with_message(words);
        let bar = match style {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        };
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }

    /// Takes it away.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}

/// A bar on the terminal for sweeps that take long; nothing where stderr is no terminal.
pub struct Progress {
    bar: ProgressBar,
    start: Instant,
}

impl Progress {
    /// Of so many states.
    pub fn new(states: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(states as u64), ProgressDrawTarget::hidden());
        Self { bar, start: Instant::now() }
    }

    /// So many are done.
    pub fn show(&self, done: usize) {
        if self.bar.is_hidden() && self.start.elapsed() > Duration::from_millis(500) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(done as u64);
    }

    /// Takes it away.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
