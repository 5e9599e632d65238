// The entry of the package for 3D.

import * as RAPIER from "./exports3.js";

export * from "./exports3.js";
export default RAPIER;
