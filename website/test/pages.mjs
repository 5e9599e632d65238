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

/** One page of each kind, by name of its picture. */
export const SAMPLES = {
    home: "/",
    guide: "/docs/guide",
    "getting-started": "/docs/guide/getting-started",
    bodies: "/docs/guide/bodies",
    joints: "/docs/guide/joints",
    architecture: "/docs/architecture",
    benchmarks: "/benchmarks",
    tables: "/docs/benchmarks/latest",
    gallery: "/gallery",
    "rust-reference": "/api/rust/rigid-body",
    "javascript-reference": "/api/javascript/classes/World",
    determinism: "/determinism",
    questions: "/docs/complaints",
};

/** Pages with a scene that starts at once. */
export const LIVE = new Set(["/", "/gallery"]);
