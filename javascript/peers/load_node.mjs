// The packages that are compared, in Node.js.

import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** The package of this repository. */
export const ours = (dimension) => import(pathToFileURL(join(import.meta.dirname, `../../rapier${dimension}d/pkg/rapier.node.mjs`)));
/** A package of the registry. */
export const published = (name) => import(name);
