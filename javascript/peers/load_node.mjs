// The package of this repository, in Node.js.

import { join } from "node:path";
import { pathToFileURL } from "node:url";

export const load = (dimension) => import(pathToFileURL(join(import.meta.dirname, `../../rapier${dimension}d/pkg/rapier.node.mjs`)));
