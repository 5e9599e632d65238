// The configuration of Vite that both testbeds share.

import { resolve } from "node:path";
import type { UserConfig } from "vite";
import { ownEngine } from "./own-engine.ts";

/** Shared memory, which threads need, exists on cross-origin isolated pages alone. */
const ISOLATED = {
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Embedder-Policy": "require-corp",
};

export function configure(testbed: string, dimension: 2 | 3): UserConfig {
    return {
        root: testbed,
        base: "./",
        plugins: [ownEngine(testbed, dimension)],
        // The shared source lies outside of the package: its imports resolve to the package's own copies.
        resolve: { dedupe: ["three", "lil-gui", "uplot"] },
        server: {
            port: 5170 + dimension,
            headers: ISOLATED,
            fs: { allow: [resolve(testbed, "..")] },
        },
        preview: { port: 5170 + dimension, headers: ISOLATED },
        build: { target: "es2022", chunkSizeWarningLimit: 4000 },
    };
}
