/// <reference lib="esnext.disposable" preserve="true" />

/** Frees objects that became unreachable without a call of `free`. */
const forgotten = typeof FinalizationRegistry === "undefined"
    ? undefined
    : new FinalizationRegistry<() => void>((free) => {
        try {
            free();
        } catch {
            // No caller could catch the error, and the object is unreachable.
        }
    });

/** The symbol of `using`, where the platform has it. */
export const DISPOSE: typeof Symbol.dispose = Symbol.dispose ?? (Symbol.for("Symbol.dispose") as never);

/** An object with memory in the module: freed by `free`, by `using`, or with the garbage. */
export class Owner {
    /** @internal The number of the object in the module. 0 after `free`. */
    id: number;
    private readonly release: (id: number) => void;

    /** @internal */
    constructor(id: number, release: (id: number) => void) {
        this.id = id;
        this.release = release;
        forgotten?.register(this, () => release(id), this);
    }

    /** Frees the memory. A second call does nothing. */
    free(): void {
        const { id } = this;
        if (id !== 0) {
            this.release(id);
            this.id = 0;
            forgotten?.unregister(this);
        }
    }

    /** Frees the memory at the end of a `using` block. */
    [DISPOSE](): void {
        this.free();
    }

    /** @internal */
    isAlive(): boolean {
        return this.id !== 0;
    }
}
