// The packages that are compared, on a page. An import map says where the packages of the registry are: see browser.mjs.

/** The package of this repository. */
export const ours = (dimension) => import(`/rapier${dimension}d/pkg/rapier.mjs`);
/** A package of the registry. */
export const published = (name) => import(name);
