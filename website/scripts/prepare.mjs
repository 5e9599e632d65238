// Generates the parts that are not committed: data of charts, hashes, stills, and both references. Runs before `start` and `build`.
//
// With `--strict`, a missing part ends the build. Without it the site starts, and a message names the part.

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { contests, growth, packages } from "./benchmarks.mjs";
import { laws } from "./fidelity.mjs";
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

/** Titles and descriptions of the scenes of the browser testbed, by name. */
const TESTBED = "testbed3d/src/scenes";
const SCENE = /id: "([^"]*)",\s*title: "([^"]*)",\s*description:\s*"([^"]*)"/g;
const described = readdirSync(join(ROOT, TESTBED)).flatMap((file) => [...read(`${TESTBED}/${file}`).matchAll(SCENE)]);
writeData("scenes.json", Object.fromEntries(described.map(([, id, title, description]) => [id, { title, description }])));

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
const pile = { platform: `${process.platform} ${process.arch}`, hashes: [] };
if (existsSync(engine)) {
    const RAPIER = await import(engine);
    await RAPIER.init();
    pile.hashes = hashes(RAPIER);
} else missing("scenes in pages need the npm package: cd rapier3d; npm install; ./build_all.sh");
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
