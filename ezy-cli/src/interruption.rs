//! Ctrl-C and the request to terminate.

use std::fmt::Display;
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::failure::Failure;

/// Whether the program was asked to end.
static ASKED: AtomicBool = AtomicBool::new(false);
/// Whether by SIGTERM.
static TERMINATED: AtomicBool = AtomicBool::new(false);
/// Whether a file grew beyond a limit; the error of writing tells it, too.
#[cfg(unix)]
static FULL: AtomicBool = AtomicBool::new(false);
static LISTENING: Once = Once::new();

/// What a shell adds to the number of a signal that ended a program.
const SIGNALLED: i32 = 128;

/// Lets a command end in good order when it is asked to by Ctrl-C (SIGINT) or SIGTERM; a second signal ends the program at once.
///
/// ```no_run
/// # fn of(scene: &dyn ezy_core::model::Scene) -> Result<(), Box<dyn std::error::Error>> {
/// use ezy_cli::Interruption;
/// use ezy_core::simulate::Simulation;
///
/// let interruption = Interruption::listen();
/// let run = Simulation::new(scene).until(3600.0).interrupted_by(interruption.flag()).run()?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Interruption(());

impl Interruption {
    /// Takes both signals from here on, to the end of the program, also where a shell had SIGINT ignored for a job in the background:
    /// `setsid` keeps such a job from Ctrl-C.
    pub fn listen() -> Self {
        LISTENING.call_once(|| {
            for signal in [SIGINT, SIGTERM] {
                // in this order, so that the first signal does not end the program; without a handler, which a system may
                // refuse, it does
                _ = flag::register_conditional_shutdown(signal, SIGNALLED + signal, &ASKED);
                if signal == SIGTERM {
                    _ = flag::register(signal, &TERMINATED);
                }
                _ = flag::register(signal, &ASKED);
            }
        });
        Self(())
    }

    /// Makes a file that grows beyond a limit of the system (`ulimit -f`) an error of writing: by itself SIGXFSZ ends the program.
    pub(super) fn outlive_full_files() {
        #[cfg(unix)]
        {
            // without a handler, which a system may refuse, the program ends
            _ = flag::register(signal_hook::consts::SIGXFSZ, &FULL);
        }
    }

    /// True once a signal has come.
    pub fn flag(&self) -> &'static AtomicBool {
        &ASKED
    }

    /// Whether a signal has come.
    pub(super) fn is_asked(self) -> bool {
        ASKED.load(Ordering::Relaxed)
    }

    /// The failure of a command that was interrupted: exit status 130 after SIGINT, 143 after SIGTERM.
    pub fn failure(&self, message: impl Display) -> Failure {
        let signal = if TERMINATED.load(Ordering::Relaxed) { SIGTERM } else { SIGINT };
        Failure::Interrupted { message: message.to_string(), status: (SIGNALLED + signal) as u8 }
    }
}
