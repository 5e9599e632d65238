// Compares the names of the published definitions with ours: node names.mjs [OURS2 OURS3]. Prints the missing
// ones, and fails if one is not in the list of deliberate differences. Both packages must be built.

import { existsSync } from "node:fs";
import { join } from "node:path";
import ts from "typescript";

const here = import.meta.dirname;

/** Names that the package leaves out: docs/guide/javascript.md, "Differences from the published packages". */
const DELIBERATE = [
    // The layer between JavaScript and the module.
    /^Raw/, /[rR]aw$/, /\.(fromRaw|intoRaw|fromRawShape|raw\w*)$/, /^Coarena/, /^scratchBuffer$/, /\.finalizeDeserialization$/,
    /\.(mapNew|unmapRemoved)\w+$/, /\.newTyped$/, /\.tempManifold$/, /^TempContactManifold\.bodies$/,
    /^(PointColliderProjection|PointProjection|Ray\w*Intersection|Shape\w+|ColliderShapeCastHit)\.fromBuffer$/,
    // Soft bodies, and the settings and shapes that only they have.
    /[sS]oftBod/, /^Soft/, /SoftFrame/, /softCluster/, /Deformable/, /^SpringCoefficients/,
    // A field of bodies that descriptions of colliders have by mistake.
    /^ColliderDesc\.rotationsEnabled$/,
];

/** The exported names of a file of definitions, with the members of classes, interfaces and enumerations. */
function namesOf(file) {
    const program = ts.createProgram([file], { target: ts.ScriptTarget.ES2022, moduleResolution: ts.ModuleResolutionKind.Bundler, module: ts.ModuleKind.ESNext, types: [] });
    const checker = program.getTypeChecker();
    const names = new Set();
    const isHidden = (symbol) => symbol.declarations?.some((part) => ts.getCombinedModifierFlags(part) & (ts.ModifierFlags.Private | ts.ModifierFlags.Protected));
    for (let symbol of checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file)))) {
        const { name } = symbol;
        if (name === "default") continue;
        if (symbol.flags & ts.SymbolFlags.Alias) symbol = checker.getAliasedSymbol(symbol);
        names.add(name);
        const members = [...(symbol.exports?.values() ?? [])];
        if (symbol.flags & ts.SymbolFlags.Class) {
            members.push(...checker.getPropertiesOfType(checker.getTypeOfSymbol(symbol)));
        }
        if (symbol.flags & (ts.SymbolFlags.Class | ts.SymbolFlags.Interface)) {
            members.push(...checker.getPropertiesOfType(checker.getDeclaredTypeOfSymbol(symbol)));
        }
        for (const member of members) {
            if (member.name !== "prototype" && !isHidden(member)) names.add(`${name}.${member.name}`);
        }
    }
    return names;
}

let failed = false;
for (const [at, dimension] of [2, 3].entries()) {
    const ours = process.argv[2 + at] ?? join(here, `../../rapier${dimension}d/pkg/types/rapier${dimension}.d.ts`);
    if (!existsSync(ours)) continue;
    const published = namesOf(join(here, `node_modules/@dimforge/rapier${dimension}d-compat/dist/rapier.d.ts`));
    const own = namesOf(ours);
    const missing = [...published].filter((name) => !own.has(name)).sort();
    const unknown = missing.filter((name) => !DELIBERATE.some((pattern) => pattern.test(name)));
    console.log(`rapier${dimension}d: ${published.size} published names, ${missing.length - unknown.length} of them left out on purpose, ${unknown.length} missing${unknown.map((name) => `\n    ${name}`).join("")}`);
    failed ||= unknown.length > 0;
}
process.exitCode = Number(failed);
