// The public items of a crate of the engine, from rustdoc's JSON.

import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";

const FEATURES = "debug-render,parallel,serde-serialize";
/** The version of the JSON for which these scripts were written. Others may work; an unknown kind ends the script. */
const FORMAT = 57;

/** Runs rustdoc on crates, and returns its JSON by name. */
export function document(root, names) {
    const target = join(process.env.CARGO_TARGET_DIR ?? join(root, "target"), "reference");
    const packages = names.flatMap((name) => ["-p", name]);
    const options = ["doc", "--quiet", "--no-deps", ...packages, "--features", FEATURES, "--target-dir", target];
    // JSON is an unstable output of rustdoc, which stable toolchains write with this variable.
    const format = { RUSTC_BOOTSTRAP: "1", RUSTDOCFLAGS: "-Z unstable-options --output-format json" };
    const run = spawnSync("cargo", options, {
        cwd: root,
        env: { ...process.env, ...format },
        stdio: ["ignore", "inherit", "inherit"],
    });
    if (run.error !== undefined) throw new Error("there is no Rust toolchain");
    if (run.status !== 0) throw new Error("rustdoc failed");
    return Object.fromEntries(names.map((name) => [name, read(join(target, `doc/${name}.json`))]));
}

function read(path) {
    const json = JSON.parse(readFileSync(path, "utf8"));
    if (json.format_version !== FORMAT) console.warn(`rustdoc's JSON has format ${json.format_version}; ${FORMAT} was expected`);
    return json;
}

export function kindOf(item) {
    return Object.keys(item.inner)[0];
}

/** Items of a module, re-exported ones included. */
function members(json, id) {
    return json.index[id].inner.module.items.flatMap((child) => {
        const item = json.index[child];
        if (item === undefined) return [];
        const used = item.inner.use;
        if (used === undefined) return [{ name: item.name, id: child, item }];
        if (!used.is_glob) return [{ name: used.name, id: used.id, item: json.index[used.id] }];
        return json.index[used.id]?.inner.module === undefined ? [] : members(json, used.id);
    });
}

const SHOWN = new Set(["struct", "enum", "trait", "type_alias", "function", "constant", "macro", "union"]);

/** Public items by module: `{ module, entries: [{ name, id, item }] }`. Items of other crates have no `item`. */
export function publicModules(json) {
    const root = json.index[json.root];
    return root.inner.module.items.flatMap((id) => {
        const used = json.index[id]?.inner.use;
        const module = json.index[used?.id ?? id];
        if (module?.inner.module === undefined || (used === undefined && module.visibility !== "public")) return [];
        const entries = members(json, used?.id ?? id).filter(({ item }) => item === undefined || SHOWN.has(kindOf(item)));
        return [{ module: used?.name ?? module.name, entries }];
    });
}
