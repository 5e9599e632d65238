//! Errors of the program, with their messages.

/// Reason for the failure of a command.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Failure {
    /// No gallery contains the scene.
    #[error(
        "there is no {dimension}D scene `{scene}`; `cargo run --release --bin all_examples{dimension} -- --list` lists them"
    )]
    NoScene {
        /// The name.
        scene: String,
        /// The number of dimensions of the gallery.
        dimension: u8,
    },
    /// The recording has another number of dimensions.
    #[error("the recording is of a world with another number of dimensions")]
    OtherDimension,
    /// The engine refuses the recording.
    #[error("{0}")]
    Recording(String),
    /// The replay diverged from the recorded run.
    #[error("the replay diverges: {0}")]
    Diverged(String),
    /// Two recordings differ.
    #[error("the recordings differ: {0}")]
    Differ(String),
}
