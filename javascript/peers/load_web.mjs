// The package of this repository, on a page.

export const load = (dimension) => import(`/rapier${dimension}d/pkg/rapier.mjs`);
