// The part of Node.js that an entry uses.

declare module "node:fs" {
    /** The bytes of a file. */
    export function readFileSync(path: URL): Uint8Array;
}
