// Lets pages import the repository's npm package, and the scenes of the testbed that run in it.

import { existsSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "@docusaurus/types";
import { ROOT } from "./repository";

const PACKAGE = join(ROOT, "rapier3d", "pkg", "rapier.mjs");

export default function engine(): Plugin {
    return {
        name: "engine",
        configureWebpack: (_, isServer) => ({
            resolve: {
                alias: {
                    // The empty module: the server draws no scenes, and without a package pages say how to build it.
                    rapier3d$: isServer || !existsSync(PACKAGE) ? false : PACKAGE,
                    "@repository": ROOT,
                },
            },
        }),
    };
}
