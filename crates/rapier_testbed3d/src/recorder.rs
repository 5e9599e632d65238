//! Screenshots and recordings of the window.

use drawing::{Animation, Image};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Largest number of frames of a recording.
const FRAMES_MAX: usize = 900;
/// Frames per second of a recording.
const RATE: u16 = 20;
/// Time for which a message is shown.
const MESSAGE_TIME: Duration = Duration::from_secs(4);

/// Takes pictures of the window.
pub(crate) struct Recorder {
    folder: PathBuf,
    recording: Option<Animation>,
    /// Seconds since the last frame of the recording.
    since_frame: f64,
    /// Message about the last file, and its time.
    message: Option<(String, Instant)>,
    written: Option<Receiver<String>>,
}

impl Recorder {
    pub(crate) fn new(folder: &Path) -> Self {
        let folder = folder.to_owned();
        Self { folder, recording: None, since_frame: 0.0, message: None, written: None }
    }

    /// Returns whether a recording is in progress.
    pub(crate) fn is_recording(&self) -> bool {
        self.recording.is_some()
    }

    /// Starts a recording.
    pub(crate) fn start(&mut self) {
        self.recording = Some(Animation::default());
        self.since_frame = 1.0;
    }

    /// Returns whether a frame of the recording is due, `elapsed` seconds after the last call.
    pub(crate) fn is_due(&mut self, elapsed: f64) -> bool {
        self.since_frame += elapsed;
        self.is_recording() && self.since_frame >= 1.0 / f64::from(RATE)
    }

    /// Adds a frame, at half the size of the picture. A recording of the greatest length ends.
    pub(crate) fn push(&mut self, picture: &Image, name: &str) {
        self.since_frame = 0.0;
        let Some(recording) = &mut self.recording else { return };
        recording.push(picture.halved());
        if recording.len() >= FRAMES_MAX {
            self.stop(name);
        }
    }

    /// Ends the recording and writes it in the background.
    pub(crate) fn stop(&mut self, name: &str) {
        let Some(recording) = self.recording.take() else { return };
        let path = self.folder.join(format!("{}-recording.png", file_name(name)));
        self.in_background(path, move |path| recording.save(path, RATE));
    }

    /// Writes a screenshot in the background.
    pub(crate) fn screenshot(&mut self, picture: Image, name: &str, step: usize) {
        let path = self.folder.join(format!("{}-{step}.png", file_name(name)));
        self.in_background(path, move |path| picture.save(path));
    }

    fn in_background(
        &mut self,
        path: PathBuf,
        write: impl FnOnce(&Path) -> std::io::Result<()> + Send + 'static,
    ) {
        let (send, receive) = channel();
        self.written = Some(receive);
        self.message = Some((format!("writing {}", path.display()), Instant::now()));
        let folder = self.folder.clone();
        std::thread::spawn(move || {
            let result = std::fs::create_dir_all(folder).and_then(|()| write(&path));
            let message = match result {
                Ok(()) => format!("wrote {}", path.display()),
                Err(error) => error.to_string(),
            };
            // The window may be closed by now.
            let _ = send.send(message);
        });
    }

    /// Returns the message about the last file for some seconds.
    pub(crate) fn message(&mut self) -> Option<&str> {
        if let Some(message) = self.written.as_ref().and_then(|written| written.try_recv().ok()) {
            self.message = Some((message, Instant::now()));
        }
        let recent = self.message.as_ref().filter(|(_, since)| since.elapsed() < MESSAGE_TIME);
        recent.map(|(message, _)| message.as_str())
    }
}

/// The name of a scene as part of a file name.
pub(crate) fn file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect()
}
