// Finds the package of this repository: linked into `node_modules`, or as built in `rapier3d/pkg`.

import { existsSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import type { Plugin } from "vite";

type Conditions = string | { [condition: string]: Conditions } | null | undefined;

/** The path of an `exports` entry under the first condition that applies. */
function choose(entry: Conditions, wanted: readonly string[]): string | null {
    if (typeof entry === "string") return entry;
    if (!entry) return null;
    for (const [condition, value] of Object.entries(entry)) {
        if (condition !== "default" && !wanted.includes(condition)) continue;
        const found = choose(value, wanted);
        if (found !== null) return found;
    }
    return null;
}

function entryOf(directory: string, wanted: readonly string[]): string | null {
    const text = readFileSync(join(directory, "package.json"), "utf8");
    const manifest = JSON.parse(text) as { exports?: { [path: string]: Conditions } | string; module?: string; main?: string };
    const exported = typeof manifest.exports === "object" && "." in manifest.exports ? manifest.exports["."] : manifest.exports;
    const path = choose(exported as Conditions, wanted) ?? manifest.module ?? manifest.main;
    if (path === undefined) return null;
    const file = resolve(directory, path);
    return existsSync(file) ? file : null;
}

/** The module file of the package, or null where it was not built. */
export function findOwnEngine(testbed: string, dimension: 2 | 3, target: "browser" | "node"): string | null {
    const name = `rapier${dimension}d`;
    const places = [
        join(testbed, "node_modules", "@dimforge", name),
        join(testbed, "node_modules", name),
        join(testbed, "..", name, "pkg"),
    ];
    const wanted = target === "browser" ? ["browser", "import", "module"] : ["node", "import", "module"];
    for (const place of places) {
        if (!existsSync(join(place, "package.json"))) continue;
        const entry = entryOf(place, wanted);
        if (entry !== null) return entry;
    }
    return null;
}

const MODULE = "virtual:own-engine";

/** Provides `virtual:own-engine`: the package's namespace, or null where it was not built. */
export function ownEngine(testbed: string, dimension: 2 | 3): Plugin {
    return {
        name: "own-engine",
        resolveId: (id) => (id === MODULE ? `\0${MODULE}` : null),
        load(id) {
            if (id !== `\0${MODULE}`) return null;
            const entry = findOwnEngine(testbed, dimension, "browser");
            if (entry === null) return "export default null;";
            return `import * as engine from ${JSON.stringify(entry)};\nexport default engine;`;
        },
    };
}
