// The entry without files: the module is part of the source. Platforms without SIMD fetch the other one.

import { setSource } from "./raw.js";

/** The module with SIMD in base 64: the bundler writes it. */
declare const MODULE: string;

function decode(text: string): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
}

setSource({
    load: async (simd) => (simd ? decode(MODULE) : fetch(new URL("./rapier.wasm", import.meta.url))),
});

export * from "#entry";
export { default } from "#entry";
