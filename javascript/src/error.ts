/** Kinds of errors. */
export type RapierErrorCode =
    | "StaleHandle"
    | "InvalidValue"
    | "Freed"
    | "Busy"
    | "WrongShape"
    | "InvalidSnapshot"
    | "Internal"
    | "NotInitialized"
    | "Unsupported";

/** The codes in the order of the numbers of crates/wasm/src/fault.rs. */
const CODES: RapierErrorCode[] = ["Internal", "StaleHandle", "InvalidValue", "Freed", "Busy", "WrongShape", "InvalidSnapshot", "Internal"];

/** An error of the engine. The message names the value, and the world is as it was before the call. */
export class RapierError extends Error {
    static {
        // The head of a stack trace takes the name from the prototype. Bundlers rename the class.
        Object.defineProperty(this.prototype, "name", { value: "RapierError", writable: true, configurable: true });
    }

    /** The kind of the error. */
    readonly code: RapierErrorCode;

    /** Creates an error. */
    constructor(code: RapierErrorCode, message: string) {
        super(message);
        this.code = code;
    }

    /** @internal */
    static ofKind(kind: number, message: string): RapierError {
        return new RapierError(CODES[kind] ?? "Internal", message);
    }
}
