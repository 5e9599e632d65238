// Packs a package that was built: node pack.mjs DIMENSION FOLDER NAME REPOSITORY [--fast]. The manifest gets the name and
// the address of the repository, unless the address is empty. The content must be that of `content.txt`. Prints the sizes
// of downloads: bytes and name.

import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const [dimension, target, name, repository, fast] = process.argv.slice(2);
const here = import.meta.dirname;
const home = `rapier${dimension}d`;
/** A fast build has no documentation and no threads. */
const ABSENT = fast === "--fast" ? ["docs/", "rapier_threads.wasm"] : [];
const root = mkdtempSync(join(tmpdir(), "pack-"));

/** The names of the packed files. Pages of the documentation count as one, because classes make them. */
function contentOf(files) {
    return [...new Set(files.map(({ path }) => path.replace(/^docs\/.*/, "docs/")))].sort();
}

/** The lines of `content.txt` for the dimension. A line may begin with the one dimension that has the file. */
function expectedContent() {
    const lines = readFileSync(join(here, "content.txt"), "utf8").split("\n").filter((line) => line !== "" && !line.startsWith("#"));
    return lines.map((line) => line.replace(new RegExp(`^${dimension}: `), "")).filter((line) => !/^\d: /.test(line) && !ABSENT.includes(line)).sort();
}

/** The differences of two lists, as lines. */
function differences(expected, found) {
    return [
        ...expected.filter((line) => !found.includes(line)).map((line) => `- ${line}`),
        ...found.filter((line) => !expected.includes(line)).map((line) => `+ ${line}`),
    ];
}

const compressed = {
    "": (bytes) => bytes,
    ".gz": (bytes) => gzipSync(bytes, { level: 9 }),
    ".br": (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }),
};

try {
    const folder = join(root, "package");
    cpSync(resolve(here, "..", home, "pkg"), folder, { recursive: true });
    const place = join(folder, "package.json");
    const manifest = { ...JSON.parse(readFileSync(place, "utf8")), name };
    if (repository !== "") {
        Object.assign(manifest, { repository: { type: "git", url: `git+${repository}.git`, directory: home }, homepage: `${repository}#readme`, bugs: `${repository}/issues` });
    }
    writeFileSync(place, `${JSON.stringify(manifest, null, 4)}\n`);
    const [{ files }] = JSON.parse(execFileSync("npm", ["pack", "--json", "--pack-destination", resolve(target)], { cwd: folder, encoding: "utf8" }));
    const wrong = differences(expectedContent(), contentOf(files));
    if (wrong.length > 0) {
        throw new Error(`the content of ${name} is not that of javascript/content.txt:\n${wrong.join("\n")}`);
    }
    for (const file of ["rapier.mjs", "rapier.node.mjs", "rapier_simd.wasm", "rapier.wasm", "rapier_threads.wasm"].filter((file) => !ABSENT.includes(file))) {
        for (const [ending, compress] of Object.entries(compressed)) {
            console.log(`${compress(readFileSync(join(folder, file))).length} ${home}/${file}${ending}`);
        }
    }
} finally {
    rmSync(root, { recursive: true });
}
