//! Small pictures of all scenes for the list, painted by a thread of their own.

use crate::player::Build;
use crate::rapier::math::DIM;
use crate::recorder::file_name;
use crate::scene::Artist;
use drawing::{Image, raster};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

/// Size of a picture in pixels.
pub(crate) const SIZE: [usize; 2] = [192, 108];
/// Steps before the picture is taken, and the longest time for them.
const STEPS: usize = 90;
const STEP_TIME: Duration = Duration::from_millis(400);
/// Rest between two scenes: the thread must not take the processor from the window.
const REST: Duration = Duration::from_millis(60);

/// Pictures that are done, and the thread that makes more.
pub(crate) struct Thumbnails {
    wanted: Sender<(String, Build)>,
    done: Receiver<(String, Image)>,
    requested: HashMap<String, Option<eframe::egui::TextureHandle>>,
}

impl Thumbnails {
    /// Pictures that are kept in a folder from run to run.
    pub(crate) fn new(folder: &Path) -> Self {
        let (wanted, requests) = channel::<(String, Build)>();
        let (results, done) = channel();
        // Scenes of both dimensions share names, and programs of both dimensions the folder.
        let folder = folder.join(format!("thumbnails{DIM}d"));
        std::thread::spawn(move || {
            // A folder that cannot be made costs the pictures' reuse only.
            let _ = std::fs::create_dir_all(&folder);
            for (name, build) in requests {
                let image = load_or_paint(&folder, &name, &build);
                if results.send((name, image)).is_err() {
                    return;
                }
            }
        });
        Self { wanted, done, requested: HashMap::new() }
    }

    /// The picture of a scene, once it is done.
    pub(crate) fn get(
        &mut self,
        ctx: &eframe::egui::Context,
        name: &str,
        build: &Build,
    ) -> Option<&eframe::egui::TextureHandle> {
        for (done, image) in self.done.try_iter() {
            let size = [image.width, image.height];
            let pixels = eframe::egui::ColorImage::from_rgb(size, &image.pixels);
            let texture = ctx.load_texture(&done, pixels, Default::default());
            self.requested.insert(done, Some(texture));
        }
        if !self.requested.contains_key(name) {
            self.requested.insert(name.to_owned(), None);
            // Without the thread, the list has no pictures.
            let _ = self.wanted.send((name.to_owned(), build.clone()));
        }
        self.requested.get(name).and_then(Option::as_ref)
    }
}

fn load_or_paint(folder: &Path, name: &str, build: &Build) -> Image {
    let path: PathBuf = folder.join(format!("{}.png", file_name(name)));
    if let Some(image) = Image::load(&path).ok().filter(|image| [image.width, image.height] == SIZE)
    {
        return image;
    }
    std::thread::sleep(REST);
    let image = paint(build);
    let _ = image.save(&path);
    image
}

fn paint(build: &Build) -> Image {
    let (mut scene, _) = build();
    let start = Instant::now();
    for _ in 0..STEPS {
        if start.elapsed() > STEP_TIME {
            break;
        }
        scene.step();
    }
    let drawing = Artist::default().draw(&scene);
    raster::picture(&drawing, &drawing.camera(&scene.view, SIZE), SIZE)
}
