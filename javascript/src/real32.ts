// The precision of the module. A build in double precision takes real64.ts instead.

/** An array of the engine's numbers. */
export type RealArray = Float32Array;
/** The constructor of such an array. */
export const RealArrayType = Float32Array;
