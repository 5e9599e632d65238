// The entry for bundlers and pages: the module is part of the script, so no bundler can lose it. Platforms
// without SIMD, and programs with threads, fetch other ones.

import { setSource } from "./raw.js";
import { webWorkers } from "./threads.js";

/** The module with SIMD, compressed, in base 64: the build writes it. */
declare const MODULE: string;
/** Whether the package contains the module with threads: the build writes it. */
declare const HAS_THREADS: boolean;

/** The module in the script. Text of base 64 alone is larger, and compresses worse on its way to a page. */
function inflate(): Promise<ArrayBuffer> {
    const bytes = Uint8Array.from(atob(MODULE), (character) => character.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

setSource({
    // Bundlers find files in expressions of this form alone.
    async load(kind) {
        if (HAS_THREADS && kind === "threads") {
            return fetch(new URL("./rapier_threads.wasm", import.meta.url));
        }
        if (kind === "scalar") {
            return fetch(new URL("./rapier.wasm", import.meta.url));
        }
        return inflate();
    },
    workers: webWorkers(),
});

export * from "#entry";
export { default } from "#entry";
