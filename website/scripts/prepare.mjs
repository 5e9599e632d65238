// Generates the parts that are not committed: data of charts, hashes, stills, and both references. Runs before `start` and `build`.
//
// With `--strict`, a missing part ends the build. Without it the site starts, and a message names the part.

import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { contests, growth, packages } from "./benchmarks.mjs";
import { changelog } from "./changelog.mjs";
import { laws } from "./fidelity.mjs";
import { gallery, weights } from "./gallery.mjs";
import { installation } from "./install.mjs";
import { writeJavaScriptReference } from "./javascript.mjs";
import { document } from "./rust/crate.mjs";
import { writeRustReferences } from "./rust/write.mjs";
import { firstFrame } from "./stills.mjs";
import { tabled } from "../plugins/listed.mjs";
import { hashes } from "../src/live/pile.mjs";

const WEBSITE = dirname(import.meta.dirname);
const ROOT = dirname(WEBSITE);
const GENERATED = join(WEBSITE, "generated");
const strict = process.argv.includes("--strict");

/** Ends a strict build, and warns otherwise. */
function missing(message) {
    console[strict ? "error" : "warn"](`${strict ? "error" : "left out"}: ${message}`);
    if (strict) process.exit(1);
}

function read(path) {
    return readFileSync(join(ROOT, path), "utf8");
}

function writeData(name, value) {
    const path = join(GENERATED, "data", name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, JSON.stringify(value));
}

writeData("contests.json", contests(read("docs/benchmarks/latest.md")));
writeData("growth.json", growth(read("docs/benchmarks/growth.md")));
writeData("packages.json", packages(read("docs/benchmarks/javascript.md")));

writeData(
    "fidelity.json",
    tabled(read("docs/fidelity/README.md")).flatMap((page) => laws(page, read(`docs/fidelity/${page}.md`))),
);

const IMAGES = "docs/images";
mkdirSync(join(GENERATED, "images"), { recursive: true });
for (const name of readdirSync(join(ROOT, IMAGES)).filter((file) => file.endsWith("-moving.png")))
    writeFileSync(join(GENERATED, "images", name), firstFrame(readFileSync(join(ROOT, IMAGES, name))));

/** One sentence on each scene of the native gallery, by name. */
const SCENES = "examples3d/scenes/src/scenes";
const scenes = readdirSync(join(ROOT, SCENES)).map((file) => [
    basename(file, ".rs"),
    /description: "([^"]*)"/.exec(read(`${SCENES}/${file}`))?.[1],
]);
writeData("descriptions.json", Object.fromEntries(scenes.filter(([, text]) => text !== undefined)));

/** The scenes of the browser testbeds. Pages without a source viewer do without the sources. */
const shown = gallery(ROOT);
writeData("sources.json", shown);
writeData(
    "scenes.json",
    shown.map(({ source, file, ...scene }) => scene),
);
for (const dimension of ["3d", "2d"])
    cpSync(join(ROOT, `testbed${dimension}/public/thumbnails`), join(GENERATED, "static/thumbnails", dimension), { recursive: true });

writeData("installation.json", installation(read("README.md")));
mkdirSync(join(GENERATED, "pages"), { recursive: true });
writeFileSync(join(GENERATED, "pages/changelog.md"), changelog(read("CHANGELOG.md")));
for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) cpSync(join(ROOT, name), join(GENERATED, "static", `${name}.txt`));

const golden = read("crates/golden/src/hashes.txt")
    .trim()
    .split("\n")
    .map((line) => line.split(/\s+/));
writeData(
    "golden.json",
    golden.map(([crate, scene, hash]) => ({ crate, scene, hash })),
);

/** The arguments of the script that compares the hashes on all platforms. */
const platforms = /"\$\{@:-([\w -]+)\}"/.exec(read("crates/golden/everywhere.sh"))?.[1];
if (platforms === undefined) throw new Error("crates/golden/everywhere.sh has no list of platforms");
writeData("platforms.json", platforms.split(" "));

const engine = join(ROOT, "rapier3d/pkg/rapier.node.mjs");
const built = ["3d", "2d"].every((dimension) => existsSync(join(ROOT, `rapier${dimension}/pkg/rapier_simd.wasm`)));
writeData("weights.json", built ? weights(ROOT) : null);
const pile = { platform: `${process.platform} ${process.arch}`, hashes: [] };
if (built) {
    const RAPIER = await import(engine);
    await RAPIER.init();
    pile.hashes = hashes(RAPIER);
} else missing("scenes in pages need the npm packages: npm install; ./build_all.sh in rapier3d and in rapier2d");
writeData("pile.json", pile);

/** The crates with a reference, and the folders of their pages. Names in guides lead to the first one. */
const CRATES = { rapier3d: "rust", rapier2d: "rust-2d" };
try {
    const documents = document(ROOT, Object.keys(CRATES));
    const crates = Object.entries(CRATES).map(([name, folder]) => ({ name, folder, json: documents[name] }));
    writeData("rust-names.json", writeRustReferences(WEBSITE, crates));
} catch (error) {
    missing(`the Rust reference: ${error.message}`);
}
writeData("javascript-names.json", writeJavaScriptReference(WEBSITE));
