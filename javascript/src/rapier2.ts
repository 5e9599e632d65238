// The entry of the package for 2D.

import * as RAPIER from "./exports2.js";

// Bundlers rename classes. Errors and tools show the names of the package.
for (const [name, part] of Object.entries(RAPIER)) {
    if (typeof part === "function") {
        Object.defineProperty(part, "name", { value: name });
    }
}

export * from "./exports2.js";
export default RAPIER;
