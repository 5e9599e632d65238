// The JavaScript reference: TypeDoc's Markdown of the package's source, without references to internal classes.

import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join } from "node:path";

/** Sections that name internal classes of the source. */
const INTERNAL = /^#{3,5} (Inherited from|Overrides|Implementation of)\n[\s\S]*?(?=^#|^\*\*\*|(?![\s\S]))/gm;
/** The default export repeats all names. */
const REPEATED = "rapier";

/** Headings of tables: as plain text they stay out of the search and of tables of contents. */
const PARTS = /^#{4,6} (Parameters|Returns|Type Parameters|Throws)$/gm;

function tidy(text) {
    return text
        .replace(INTERNAL, "").replace(PARTS, "**$1**")
        .replace(/^## Extends\n\n(?:- `\w+`\n)+\n/m, "")
        .replace(/^## Namespaces\n[\s\S]*?(?=^## )/m, "");
}

/** Writes the reference of `rapier3d` into `generated/api/javascript`. Returns addresses of classes by name. */
export function writeJavaScriptReference(website) {
    const sources = join(dirname(website), "javascript");
    const target = join(website, "generated/api/javascript");
    rmSync(target, { recursive: true, force: true });
    execFileSync(process.execPath, [join(sources, "generate.mjs"), join(sources, "src/functions.ts")]);
    const require = createRequire(join(website, "package.json"));
    const typedoc = join(dirname(require.resolve("typedoc/package.json")), "bin/typedoc");
    execFileSync(process.execPath, [typedoc, "--options", "typedoc.json"], { cwd: website, stdio: "inherit" });
    rmSync(join(target, REPEATED), { recursive: true, force: true });
    const names = {};
    for (const file of readdirSync(target, { recursive: true })) {
        if (!file.endsWith(".md")) continue;
        const path = join(target, file);
        writeFileSync(path, tidy(readFileSync(path, "utf8")));
        if (file.includes("/")) names[basename(file, ".md")] = `/api/javascript/${file.replace(/\.md$/, "")}`;
    }
    return names;
}
