// Worlds in 2D.

export { World } from "./world.js";
