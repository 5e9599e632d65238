// The precision of a module that was built with the feature f64.

/** An array of the engine's numbers. */
export type RealArray = Float64Array;
/** The constructor of such an array. */
export const RealArrayType = Float64Array;
