//! A loaded scene with everything that the window keeps about it.

use crate::camera::OrbitCamera;
use crate::player::{Build, Pace, Player};
use crate::pointer::{Grip, pick, throw};
use crate::rapier::prelude::*;
use crate::scene::{Artist, point};
use crate::stages::{Part, StagePlot};
use drawing::{Camera, Drawing, Point};
use gallery::Category;
use std::time::Instant;

/// A scene in the list of the window.
pub(crate) struct Demo {
    pub name: String,
    pub description: String,
    /// File with its source, as a path in the repository. Empty for demos from functions.
    pub source: &'static str,
    pub category: Category,
    pub build: Build,
}

/// A running demo.
pub(crate) struct Session {
    pub player: Player,
    /// The same scene with other parameters, stepped along.
    pub other: Option<Player>,
    /// Whether the panel of parameters edits the other one.
    pub edits_other: bool,
    pub pace: Pace,
    pub camera: OrbitCamera,
    pub artist: Artist,
    pub grip: Option<Grip>,
    pub follow: bool,
    pub plot: StagePlot,
    home: OrbitCamera,
    /// The camera of the scene, if it has one.
    wanted: Option<OrbitCamera>,
    /// Points of the first picture, which the home frames.
    points: Vec<Point>,
    /// The aspect that the home fits.
    fitted: f32,
}

impl Session {
    pub(crate) fn new(demo: &Demo) -> Self {
        let (player, wanted) = Player::new(demo.build.clone());
        let mut artist = Artist::default();
        let points = artist.draw(&player.scene).points_to_frame();
        let camera = OrbitCamera { target: [0.0; 3], distance: 10.0, yaw: 0.0, pitch: 0.0 };
        Self {
            player,
            other: None,
            edits_other: false,
            pace: Pace::default(),
            camera,
            artist,
            grip: None,
            follow: false,
            plot: StagePlot::default(),
            home: camera,
            wanted,
            points,
            fitted: 0.0,
        }
    }

    /// Fits the first view to a picture of an aspect, and moves the camera there unless the mouse has moved
    /// it.
    pub(crate) fn fit(&mut self, aspect: f32) {
        if (aspect - self.fitted).abs() < 0.01 {
            return;
        }
        let at_home = self.camera == self.home;
        let fit = || OrbitCamera::framing(&self.player.scene.view, &self.points, aspect);
        (self.home, self.fitted) = (self.wanted.unwrap_or_else(fit), aspect);
        if at_home {
            self.camera = self.home;
        }
    }

    /// Returns the camera to the place where it was at first.
    pub(crate) fn go_home(&mut self) {
        self.camera = self.home;
        self.follow = false;
    }

    /// Builds the scene anew.
    pub(crate) fn restart(&mut self) {
        self.player.restart();
        if let Some(other) = &mut self.other {
            other.restart();
        }
        self.grip = None;
        self.artist.selected = None;
    }

    /// Shows the scene a second time, beside the first, or stops to do so.
    pub(crate) fn set_comparison(&mut self, wanted: bool) {
        if wanted && self.other.is_none() {
            self.restart();
            let mut other = self.player.twin();
            other.scene.world.integration_parameters =
                self.player.scene.world.integration_parameters;
            self.other = Some(other);
        }
        if !wanted {
            self.other = None;
            self.edits_other = false;
        }
    }

    /// Runs the steps of a frame that began at a moment, `elapsed` seconds after the last one.
    pub(crate) fn advance(&mut self, begin: Instant, elapsed: f64) {
        let Self { player, other, pace, grip, plot, .. } = self;
        if player.rewound.is_some() && pace.running {
            player.resume();
        }
        let grip = grip.as_ref();
        pace.run(elapsed, || {
            player.step(grip);
            plot.after_step(&player.scene.world);
            if let Some(other) = other {
                other.step(None);
            }
            f64::from(player.scene.world.integration_parameters.dt)
        });
        plot.add_rest(Part::BesideSteps, begin);
    }

    /// Draws the scene that is shown, and moves a following camera.
    pub(crate) fn draw(&mut self, other: bool) -> Drawing {
        let player = match &self.other {
            Some(second) if other => second,
            _ => &self.player,
        };
        let scene = player.shown();
        if self.follow && !other {
            let body =
                self.artist.selected.and_then(|handle| scene.world.colliders.get(handle)?.parent());
            if let Some(body) = body.and_then(|body| scene.world.bodies.get(body)) {
                self.camera.target = point(body.center_of_mass());
            }
        }
        let mut drawing = self.artist.draw(scene);
        if let (Some(grip), false) = (&self.grip, other)
            && let Some(anchor) = grip.anchor(&scene.world)
        {
            let color = drawing::Color::from_hsl(48.0, 1.0, 0.65, 1.0);
            let (from, to) = (point(anchor), point(grip.target));
            drawing.line(drawing::Line { from, to, color, on_top: true });
        }
        drawing
    }

    /// Selects the collider under a place of the picture, and takes hold of its body if that is dynamic.
    pub(crate) fn grab(&mut self, camera: &Camera, at: [f32; 2]) {
        let [origin, direction] = camera.ray(at[0], at[1]).map(vector);
        let world = &self.player.shown().world;
        let hit = pick(world, origin, direction);
        self.artist.selected = hit.map(|(handle, _)| handle);
        self.grip = hit.and_then(|(handle, place)| {
            let body = world.colliders.get(handle)?.parent()?;
            Grip::new(world, body, place)
        });
        // A pull changes the future; a selection does not.
        if self.grip.is_some() {
            self.player.resume();
        }
    }

    /// Moves the target of the pull to a place of the picture, at the distance of the held point.
    pub(crate) fn drag(&mut self, camera: &Camera, at: [f32; 2]) {
        let Some(grip) = &mut self.grip else { return };
        let w = camera.see(point(grip.target)).w;
        grip.target = vector(camera.point_at(at[0], at[1], w));
    }

    /// Removes the body of the selected collider.
    pub(crate) fn remove_selected(&mut self) {
        let Some(handle) = self.artist.selected.take() else { return };
        self.grip = None;
        let world = self.player.world_mut();
        match world.colliders.get(handle).map(|collider| collider.parent()) {
            Some(Some(body)) => drop(world.remove_body(body)),
            Some(None) => drop(world.remove_collider(handle)),
            None => {}
        }
    }

    /// Throws a ball towards a place of the picture.
    pub(crate) fn throw(&mut self, camera: &Camera, at: [f32; 2]) {
        let size = self.camera.distance * if DIM == 3 { 1.0 } else { 2.0 };
        let [origin, direction] = camera.ray(at[0], at[1]);
        let world = self.player.world_mut();
        if DIM == 3 {
            throw(world, vector(origin), vector(direction), size as Real);
        } else {
            let corner = vector(camera.point_at(-0.95, 0.9, 1.0));
            let direction = (vector(origin) - corner).normalize_or(Vector::X);
            throw(world, corner, direction, size as Real);
        }
    }
}

/// A point of a drawing in the world.
pub(crate) fn vector(point: Point) -> Vector {
    let mut vector = Vector::ZERO;
    for (axis, value) in Vector::AXES.into_iter().zip(point) {
        vector += axis * value as Real;
    }
    vector
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panels::inspect;
    use crate::scene::Scene;
    use eframe::egui;

    /// A session with a ball on a fixed box, 60 steps after its start.
    fn session() -> Session {
        let build = || {
            let mut world = PhysicsWorld::new();
            world.insert(
                RigidBodyBuilder::dynamic().translation(Vector::Y),
                ColliderBuilder::ball(0.5),
            );
            let floor = SharedShape::new(Cuboid::new(Vector::splat(0.5)));
            world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::new(floor));
            let view =
                if DIM == 2 { drawing::View::flat() } else { drawing::View::orbit(0.0, 0.0) };
            (Scene::new(world, view), None)
        };
        let mut session = Session::new(&Demo {
            name: String::new(),
            description: String::new(),
            source: "",
            category: Category::Basics,
            build: std::sync::Arc::new(build),
        });
        (0..60).for_each(|_| session.player.step(None));
        session
    }

    /// Presses the mouse on a point of the world.
    fn press(session: &mut Session, point: Point) {
        session.fit(1.0);
        let camera = session.camera.camera(1.0);
        let seen = camera.see(point);
        session.grab(&camera, [seen.x / seen.w, seen.y / seen.w]);
    }

    #[test]
    fn an_inspected_selection_keeps_the_history() {
        let mut session = session();
        session.artist.selected =
            session.player.scene.world.colliders.iter().map(|(c, _)| c).next();
        let copies = session.player.history.len();
        session.player.rewound = Some(2);
        let mut shown = egui::Context::default()
            .run_ui(egui::RawInput::default(), |ui| inspect::show(ui, &mut session));
        // No adapter takes the letters.
        shown.textures_delta.clear();
        assert!(session.artist.selected.is_some());
        assert_eq!((session.player.rewound, session.player.history.len()), (Some(2), copies));
    }

    #[test]
    fn only_a_held_body_ends_the_rewound_state() {
        let mut session = session();
        let copies = session.player.history.len();
        session.player.rewound = Some(2);
        press(&mut session, [0.0, 0.0, 0.0]);
        assert!(session.artist.selected.is_some() && session.grip.is_none());
        assert_eq!((session.player.rewound, session.player.history.len()), (Some(2), copies));
        press(&mut session, [0.0, 1.0, 0.0]);
        assert!(session.grip.is_some());
        assert_eq!((session.player.rewound, session.player.history.len()), (None, 3));
    }
}
