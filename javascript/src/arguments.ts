// Checks of arguments that are objects. A wrong one is an error that names the argument and the value.

import { RapierError } from "./error.js";

/** A value as a text of an error. */
function shown(value: unknown): string {
    if (typeof value === "string") {
        return JSON.stringify(value);
    }
    if (typeof value === "function") {
        return `the function ${value.name}`.trimEnd();
    }
    if (typeof value !== "object" || value === null) {
        return String(value);
    }
    const kind: unknown = (value as { constructor?: { name?: unknown } }).constructor?.name;
    return typeof kind === "string" && kind !== "" && kind !== "Object" ? `an object of ${kind}` : "an object";
}

/** The error of an argument that is something else than expected. */
export function wrong(name: string, value: unknown, expected: string): RapierError {
    return new RapierError("InvalidValue", `${name} is ${shown(value)}, but must be ${expected}`);
}

/** Requires an object, whatever its class: other libraries have vectors of their own. */
export function requireObject(value: unknown, name: string, expected: string): void {
    if (typeof value !== "object" || value === null) {
        throw wrong(name, value, expected);
    }
}

/** Requires a list of numbers: an array, or an object with a length and indices. */
export function requireList(value: unknown, name: string): void {
    if (typeof value !== "object" || value === null || typeof (value as ArrayLike<number>).length !== "number") {
        throw wrong(name, value, "an array of numbers");
    }
}

/** Requires an object of a class. Proxies of such objects pass. */
export function requireClass<T>(value: unknown, kind: { readonly prototype: T }, name: string, expected: string): asserts value is T {
    if (!(value instanceof (kind as never))) {
        throw wrong(name, value, expected);
    }
}

/**
 * The number. Other values would be converted: null to 0, and a text to its number. NaN and infinite numbers
 * pass, because the module states the range of each number.
 */
export function real(value: number, name: string): number {
    if (typeof value !== "number") {
        throw wrong(name, value, "a number");
    }
    return value;
}

/** A whole number: an enumerator, bits or an index. */
export function integer(value: number, name: string): number {
    if (!Number.isInteger(value)) {
        throw wrong(name, value, "a whole number");
    }
    return value;
}

/** Requires finite numbers as the components of a vector or a rotation. */
export function requireComponents(components: readonly unknown[], name: string): void {
    if (!components.every(Number.isFinite)) {
        throw new RapierError("InvalidValue", `${name} is [${components.map(shown).join(", ")}], but its components must be finite numbers`);
    }
}

/** A whole number that is not negative. */
export function requireCount(value: number, name: string): number {
    if (!(Number.isInteger(value) && value >= 0)) {
        throw wrong(name, value, "a whole number that is not negative");
    }
    return value;
}

/** Requires the limits of a cast as numbers. */
export function requireLimits(targetDistance: number, maxToi: number): void {
    real(targetDistance, "targetDistance");
    real(maxToi, "maxToi");
}

/** Requires a function. */
export function requireFunction(value: unknown, name: string): void {
    if (typeof value !== "function") {
        throw wrong(name, value, "a function");
    }
}
