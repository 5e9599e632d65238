// The pages of the built site, and the samples that are photographed and checked for accessibility.

import { readdirSync } from "node:fs";
import { join } from "node:path";

/** Paths of all pages of a build. */
export function allPages(build) {
    return readdirSync(build, { recursive: true })
        .filter((file) => file === "index.html" || file.endsWith("/index.html"))
        .map((file) => `/${file.replace(/index\.html$/, "").replace(/\/$/, "")}`)
        .sort();
}

/** Scenes whose pages stand for those of all scenes: each loads an engine and draws. */
const SCENES = new Set(["/gallery/3d/car", "/gallery/2d/washer"]);

/** The pages that the check visits. */
export function visitedPages(build) {
    return allPages(build).filter((path) => SCENES.has(path) || !/^\/gallery\/[23]d\//.test(path));
}

/** One page of each kind, by name of its picture. */
export const SAMPLES = {
    home: "/",
    guide: "/docs/guide",
    "getting-started": "/docs/guide/getting-started",
    bodies: "/docs/guide/bodies",
    joints: "/docs/guide/joints",
    architecture: "/docs/architecture",
    benchmarks: "/benchmarks",
    fidelity: "/fidelity",
    tables: "/docs/benchmarks/latest",
    gallery: "/gallery",
    scene: "/gallery/3d/car",
    "scene-2d": "/gallery/2d/washer",
    changelog: "/changelog",
    "rust-topic": "/api/rust/joints",
    "rust-reference": "/api/rust/rigid-body/RigidBody",
    "javascript-reference": "/api/javascript/classes/World",
    determinism: "/determinism",
    questions: "/docs/complaints",
};

/** Pages with a scene that starts at once. */
export const LIVE = new Set(["/", "/gallery", "/gallery/3d/car", "/gallery/2d/washer"]);
