// Lets pages import the repository's npm package and the scenes of the testbed that run in it.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "@docusaurus/types";
import { ROOT } from "./repository";

const WEBSITE = join(ROOT, "website");

/** The search of the bar: the plugin lists methods of one name before the guide. */
const SEARCH = join(WEBSITE, "src/search/ranked.js");

/** The package of a dimension, or the empty module: the server draws no scenes, and without a package pages say how to build it. */
function engine(name: string, isServer: boolean): string | false {
    const path = join(ROOT, name, "pkg", "rapier.file.mjs");
    return !isServer && existsSync(path) && path;
}

/** Files that decide how documents are rendered. The bundler does not see them. */
function renderingFiles(): string[] {
    const plugins = readdirSync(__dirname).map((name) => join("plugins", name));
    return [...plugins, "yarn.lock", "generated/data/rust-names.json", "generated/data/javascript-names.json"];
}

/** A name for the bundler's cache that changes with the rendering. */
function cacheVersion(): string {
    const hash = createHash("sha256");
    for (const file of renderingFiles()) {
        const path = join(WEBSITE, file);
        if (existsSync(path)) hash.update(readFileSync(path));
    }
    return hash.digest("hex");
}

export default function bundler(): Plugin {
    return {
        name: "bundler",
        configureWebpack: (config, isServer, { currentBundler }) => ({
            plugins: [
                new currentBundler.instance.NormalModuleReplacementPlugin(/^\.\.\/searchByWorker$/, (request) => {
                    if (/SearchBar$/.test(request.context)) request.request = SEARCH;
                }),
            ],
            // Development has a cache in memory, without a version.
            cache:
                typeof config.cache === "object" && config.cache.type === "filesystem"
                    ? { ...config.cache, version: cacheVersion() }
                    : config.cache,
            resolve: {
                alias: {
                    rapier2d$: engine("rapier2d", isServer),
                    rapier3d$: engine("rapier3d", isServer),
                    "@repository": ROOT,
                },
            },
        }),
    };
}
