// The entry of the package for 2D.

import * as RAPIER from "./exports2.js";

export * from "./exports2.js";
export default RAPIER;
