import { real } from "./arguments.js";
import { raw } from "./raw.js";
import type { World } from "./world.js";

/** The parameters in the order of crates/wasm/src/world.rs. */
const Parameter = {
    dt: 0,
    solverIterations: 1,
    pgsIterations: 2,
    ccdSubsteps: 3,
    lengthUnit: 4,
    contactErp: 5,
    allowedLinearError: 6,
    predictionDistance: 7,
    contactFrequency: 8,
    contactDampingRatio: 9,
    additionalFrictionIterations: 10,
} as const;

/** Length and accuracy of the steps of a world. */
export class IntegrationParameters {
    private readonly world: World;

    /** @internal Worlds make their parameters. */
    constructor(world: World) {
        this.world = world;
    }

    private get(parameter: number): number {
        return raw.world_parameter(this.world.id, parameter);
    }

    private set(parameter: number, name: string, value: number): void {
        raw.world_set_parameter(this.world.id, parameter, real(value, name));
    }

    /** The length of a step in seconds. Default: 1/60. */
    get dt(): number {
        return this.get(Parameter.dt);
    }

    set dt(value: number) {
        this.set(Parameter.dt, "dt", value);
    }

    /** The fraction of a penetration that a step removes. */
    get contact_erp(): number {
        return this.get(Parameter.contactErp);
    }

    set contact_erp(value: number) {
        this.set(Parameter.contactErp, "contact_erp", value);
    }

    /** Sets the fraction of a penetration that a step removes as the frequency of a spring (1/s). */
    set contact_natural_frequency(value: number) {
        this.set(Parameter.contactFrequency, "contact_natural_frequency", value);
    }

    /** The damping ratio of contacts. */
    get contact_damping_ratio(): number {
        return this.get(Parameter.contactDampingRatio);
    }

    set contact_damping_ratio(value: number) {
        this.set(Parameter.contactDampingRatio, "contact_damping_ratio", value);
    }

    /** The size of a typical body. Default: 1. */
    get lengthUnit(): number {
        return this.get(Parameter.lengthUnit);
    }

    set lengthUnit(value: number) {
        this.set(Parameter.lengthUnit, "lengthUnit", value);
    }

    /** The allowed penetration, in length units. */
    get normalizedAllowedLinearError(): number {
        return this.get(Parameter.allowedLinearError);
    }

    set normalizedAllowedLinearError(value: number) {
        this.set(Parameter.allowedLinearError, "normalizedAllowedLinearError", value);
    }

    /** The distance below which contacts are computed, in length units. */
    get normalizedPredictionDistance(): number {
        return this.get(Parameter.predictionDistance);
    }

    set normalizedPredictionDistance(value: number) {
        this.set(Parameter.predictionDistance, "normalizedPredictionDistance", value);
    }

    /** Substeps of the solver in a step. */
    get numSolverIterations(): number {
        return this.get(Parameter.solverIterations);
    }

    set numSolverIterations(value: number) {
        this.set(Parameter.solverIterations, "numSolverIterations", value);
    }

    /** Iterations of the solver in a substep. */
    get numInternalPgsIterations(): number {
        return this.get(Parameter.pgsIterations);
    }

    set numInternalPgsIterations(value: number) {
        this.set(Parameter.pgsIterations, "numInternalPgsIterations", value);
    }

    /** Iterations of all constraints in a substep without position correction, beyond the usual one. Default: 0. */
    get numAdditionalFrictionIterations(): number {
        return this.get(Parameter.additionalFrictionIterations);
    }

    set numAdditionalFrictionIterations(value: number) {
        this.set(Parameter.additionalFrictionIterations, "numAdditionalFrictionIterations", value);
    }

    /** The largest number of parts into which impacts of fast bodies divide a step (default 1). 0 switches continuous collision detection off. */
    get maxCcdSubsteps(): number {
        return this.get(Parameter.ccdSubsteps);
    }

    set maxCcdSubsteps(value: number) {
        this.set(Parameter.ccdSubsteps, "maxCcdSubsteps", value);
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
