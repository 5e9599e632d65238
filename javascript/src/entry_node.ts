// The entry for Node.js: the module is a file beside this one.

import { readFileSync } from "node:fs";
import { setSource } from "./raw.js";

const read = (simd: boolean): Uint8Array<ArrayBuffer> =>
    new Uint8Array(readFileSync(new URL(simd ? "./rapier_simd.wasm" : "./rapier.wasm", import.meta.url)));

setSource({ load: async (simd) => read(simd), loadNow: read });

export * from "#entry";
export { default } from "#entry";
