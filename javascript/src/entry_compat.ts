// The entry without files: the module is part of the source. Platforms without SIMD, and programs with
// threads, fetch other ones.

import { setSource } from "./raw.js";
import { webWorkers } from "./threads.js";

/** The module with SIMD in base 64: the build writes it. */
declare const MODULE: string;
/** Whether the package contains the module with threads: the build writes it. */
declare const HAS_THREADS: boolean;

function decode(text: string): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
}

setSource({
    async load(kind) {
        if (HAS_THREADS && kind === "threads") {
            return fetch(new URL("./rapier_threads.wasm", import.meta.url));
        }
        return kind === "simd" ? decode(MODULE) : fetch(new URL("./rapier.wasm", import.meta.url));
    },
    workers: webWorkers(),
});

export * from "#entry";
export { default } from "#entry";
