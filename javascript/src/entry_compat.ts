// The entry without files: the module is part of the source. Platforms without SIMD, and programs with threads, fetch other ones.

import { FILES, setSource } from "./raw.js";
import { startWebWorker, webCores } from "./threads.js";

/** The module with SIMD in base 64: the bundler writes it. */
declare const MODULE: string;

function decode(text: string): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
}

setSource({
    load: async (kind) => (kind === "simd" ? decode(MODULE) : fetch(new URL(FILES[kind], import.meta.url))),
    startWorker: startWebWorker,
    cores: webCores,
});

export * from "#entry";
export { default } from "#entry";
