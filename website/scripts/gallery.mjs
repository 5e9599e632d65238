// The scenes of both browser testbeds: titles, descriptions, groups and sources, in the order of the galleries.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { scenesOf } from "../../testbed/tools/sources.mjs";

/** Files of scenes in the order in which `index.ts` lists them. */
function files(index) {
    const from = new Map();
    for (const [, names, file] of index.matchAll(/^import \{ ([^}]*) \} from "\.\/([^"]*)";$/gm))
        for (const name of names.split(", ")) from.set(name, file);
    return new Set([...index.matchAll(/^ {4}\.\.\.(\w+),$/gm)].map(([, name]) => from.get(name)));
}

/** Scenes of one testbed: `{ dimension, file, id, title, description, group, steered, action, source }`. */
function scenes(root, dimension) {
    const folder = `testbed${dimension}/src/scenes`;
    const text = (file) => readFileSync(join(root, folder, file), "utf8");
    return [...files(text("index.ts"))].flatMap((file) =>
        scenesOf(text(file)).map((scene) => ({ dimension, file: `${folder}/${file}`, ...scene })),
    );
}

/** Bytes of a package's WebAssembly module as a server sends it. */
function weight(root, dimension) {
    return gzipSync(readFileSync(join(root, `rapier${dimension}/pkg/rapier_simd.wasm`))).length;
}

export function gallery(root) {
    return [...scenes(root, "3d"), ...scenes(root, "2d")];
}

/** Bytes by dimension, or nothing without the packages. */
export function weights(root) {
    return { "3d": weight(root, "3d"), "2d": weight(root, "2d") };
}
