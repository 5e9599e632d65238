// The entry for bundlers and pages: the module is fetched from beside this file.

import { setSource } from "./raw.js";
import { startWebWorker, webCores } from "./threads.js";

setSource({
    // Bundlers find files in expressions of this form alone.
    load(kind) {
        switch (kind) {
            case "threads": return fetch(new URL("./rapier_threads.wasm", import.meta.url));
            case "simd": return fetch(new URL("./rapier_simd.wasm", import.meta.url));
            default: return fetch(new URL("./rapier.wasm", import.meta.url));
        }
    },
    startWorker: startWebWorker,
    cores: webCores,
});

export * from "#entry";
export { default } from "#entry";
