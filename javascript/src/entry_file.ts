// The entry whose module is a file beside the script: a smaller download, for bundlers that copy the file.

import { setSource } from "./raw.js";
import { webWorkers } from "./threads.js";

/** Whether the package contains the module with threads: the build writes it. */
declare const HAS_THREADS: boolean;

setSource({
    // Bundlers find files in expressions of this form alone, and fail if one is missing.
    load(kind) {
        if (HAS_THREADS && kind === "threads") {
            return fetch(new URL("./rapier_threads.wasm", import.meta.url));
        }
        return kind === "simd" ? fetch(new URL("./rapier_simd.wasm", import.meta.url)) : fetch(new URL("./rapier.wasm", import.meta.url));
    },
    workers: webWorkers(),
});

export * from "#entry";
export { default } from "#entry";
