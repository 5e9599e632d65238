declare module "virtual:own-engine" {
    const engine: unknown;
    export default engine;
}

declare module "*.css" {}

/** Vite's import of many files. */
interface ImportMeta {
    glob(pattern: string, options: { query: "?raw"; import: "default" }): Record<string, () => Promise<string>>;
}
