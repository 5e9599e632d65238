// Prints the sizes of the packages: the downloads of a page, raw and compressed with brotli.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";

const here = import.meta.dirname;
const ours = (dimension, ...files) => files.map((file) => join(here, `../../rapier${dimension}d/pkg`, file));
const theirs = (...files) => files.map((file) => join(here, "node_modules", file));

const packages = {
    "rapier3d (ours, one script)": ours(3, "rapier.mjs"),
    "rapier3d (ours, SIMD)": ours(3, "rapier_simd.wasm", "rapier.file.mjs"),
    "rapier3d (ours, scalar)": ours(3, "rapier.wasm", "rapier.file.mjs"),
    "rapier2d (ours, one script)": ours(2, "rapier.mjs"),
    "rapier2d (ours, SIMD)": ours(2, "rapier_simd.wasm", "rapier.file.mjs"),
    "rapier2d (ours, scalar)": ours(2, "rapier.wasm", "rapier.file.mjs"),
    "@dimforge/rapier3d-compat": theirs("@dimforge/rapier3d-compat/dist/rapier_wasm3d_bg.wasm", "@dimforge/rapier3d-compat/dist/rapier.mjs"),
    "@dimforge/rapier3d-simd-compat": theirs("@dimforge/rapier3d-simd-compat/dist/rapier_wasm3d_bg.wasm"),
    "@dimforge/rapier2d-compat": theirs("@dimforge/rapier2d-compat/dist/rapier_wasm2d_bg.wasm"),
    "jolt-physics": theirs("jolt-physics/dist/jolt-physics.wasm.wasm", "jolt-physics/dist/jolt-physics.wasm.js"),
    "box2d3-wasm": theirs("box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.wasm", "box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.mjs"),
};

/** The bytes of a file as a page downloads it. A module in a script of another package counts as the module. */
function bytesOf(file) {
    const bytes = readFileSync(file);
    return file.endsWith("js") && file.includes("node_modules") ? Buffer.from(bytes.toString("utf8").replace(/[A-Za-z0-9+/=]{10000,}/g, "")) : bytes;
}

const compressed = (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }).length;
const kilo = (bytes) => Math.round(bytes / 1000);

console.log("| package | raw, kB | brotli, kB |\n|---|--:|--:|");
for (const [name, files] of Object.entries(packages)) {
    const found = files.filter((file) => existsSync(file));
    if (found.length === 0) {
        console.log(`| ${name} | not there | |`);
        continue;
    }
    const contents = found.map(bytesOf);
    const sum = (numbers) => numbers.reduce((total, number) => total + number, 0);
    console.log(`| ${name} | ${kilo(sum(contents.map((bytes) => bytes.length)))} | ${kilo(sum(contents.map(compressed)))} |`);
}
