//! How a gallery shows its scenes: in a window, or not.
//!
//! This is the place where the windowed testbed will plug in, as a second variant that is chosen when
//! there is a display and `--headless` was not given.

/// How the scenes are shown.
pub(crate) enum Mode {
    /// Scenes run as fast as they can and end as pictures and a table.
    Headless {
        /// Something to tell the user first.
        note: Option<&'static str>,
    },
}

impl Mode {
    /// The mode for this machine.
    pub(crate) fn choose(headless_wanted: bool) -> Self {
        let note = (!headless_wanted && has_display())
            .then_some("There is no window yet; running headless, with a picture of every scene.");
        Mode::Headless { note }
    }
}

/// Could a window be opened here?
fn has_display() -> bool {
    if cfg!(any(target_os = "windows", target_os = "macos")) {
        return true;
    }
    ["WAYLAND_DISPLAY", "DISPLAY"]
        .iter()
        .any(|name| std::env::var_os(name).is_some_and(|value| !value.is_empty()))
}
