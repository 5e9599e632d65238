// Writes the TypeScript interface of the functions that crates/wasm exports:
//     node generate.mjs OUTPUT
// The source is the `exports!` blocks. A function of one dimension becomes optional in neither: both packages
// share the interface.

import { readFileSync, readdirSync, writeFileSync } from "node:fs";

const [output] = process.argv.slice(2);
const folder = new URL("../crates/wasm/src/", import.meta.url);
const kinds = { f64: "number", f32: "number", Real: "number", u32: "number", i32: "number", usize: "number", bool: "number", u64: "bigint" };

const functions = [];
for (const file of readdirSync(folder).sort()) {
    const text = readFileSync(new URL(file, folder), "utf8");
    for (const [, block] of text.matchAll(/^exports! \{\n([\s\S]*?)^\}/gm)) {
        for (const [, name, parameters, result] of block.matchAll(/^    fn (\w+)\(([^)]*)\)(?: -> (\w+))? \{/gm)) {
            const list = parameters.split(",").filter((parameter) => parameter.trim() !== "").map((parameter) => {
                const [label, kind] = parameter.split(":").map((part) => part.trim());
                if (!(kind in kinds)) {
                    throw new Error(`${file}: ${name} has a parameter of type ${kind}`);
                }
                return `${label}: ${kinds[kind]}`;
            });
            functions.push(`    ${name}(${list.join(", ")}): ${result ? kinds[result] : "void"};`);
        }
    }
}
functions.sort();
writeFileSync(output, `// Written by generate.mjs from crates/wasm/src.

/** The functions of the WebAssembly module. */
export interface Functions {
${functions.join("\n")}
}
`);
