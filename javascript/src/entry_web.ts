// The entry for bundlers and pages: the module is fetched from beside this file.

import { setSource } from "./raw.js";

setSource({
    load: (simd) =>
        simd
            ? fetch(new URL("./rapier_simd.wasm", import.meta.url))
            : fetch(new URL("./rapier.wasm", import.meta.url)),
});

export * from "#entry";
export { default } from "#entry";
