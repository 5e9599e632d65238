// The entry of the package for 3D.

import * as RAPIER from "./exports3.js";

// Bundlers rename classes. Errors and tools show the names of the package.
for (const [name, part] of Object.entries(RAPIER)) {
    if (typeof part === "function") {
        Object.defineProperty(part, "name", { value: name });
    }
}

export * from "./exports3.js";
export default RAPIER;
