// The repository: its folder on this machine, and its address where the manifest has one.

import { existsSync, readFileSync, statSync } from "node:fs";
import { join, resolve } from "node:path";

/** The root folder of the repository. */
export const ROOT = resolve(__dirname, "..", "..");

/** Reads a text file of the repository. */
export function read(path: string): string {
    return readFileSync(join(ROOT, path), "utf8");
}

const manifest = read("Cargo.toml");

/** Returns a string field of the workspace's manifest. */
function field(name: string): string | undefined {
    return new RegExp(`^${name} = "([^"]*)"`, "m").exec(manifest)?.[1];
}

export const VERSION = field("version") ?? "";

/** Address of the repository. Without one, links to source files become plain text. */
export const REPOSITORY: string | undefined = process.env.REPOSITORY_URL ?? field("repository");

/** Returns the address of a file or folder of the repository in a revision, if the repository has an address. */
export function fileView(path: string, revision = "main"): string | undefined {
    if (REPOSITORY === undefined) return undefined;
    const kind = existsSync(join(ROOT, path)) && statSync(join(ROOT, path)).isDirectory() ? "tree" : "blob";
    return `${REPOSITORY}/${kind}/${revision}/${path}`;
}
