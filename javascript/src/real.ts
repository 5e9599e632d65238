// The precision of the module. A build in double precision replaces this file by real64.ts.

/** An array of the engine's numbers. */
export type RealArray = Float32Array;
/** The constructor of such an array. */
export const RealArrayType = Float32Array;
