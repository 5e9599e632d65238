import { requireCount } from "./arguments.js";
import { type InitOptions, load, raw } from "./raw.js";

/** Loads the engine. No other function works before its end. */
export function init(options?: InitOptions): Promise<void> {
    return load(options);
}

/** The version of the engine. */
export function version(): string {
    return VERSION;
}

/** Grows the memory once, so that later allocations of this many bytes do not. */
export function reserveMemory(extraBytesCount: number): void {
    raw.memory_reserve(requireCount(extraBytesCount, "extraBytesCount"));
}

/** The package's version: the bundler writes it. */
declare const VERSION: string;

/** Bytes of the module's memory. The memory grows and never shrinks. */
export function memoryBytes(): number {
    return raw.memory.buffer.byteLength;
}
