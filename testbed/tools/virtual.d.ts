declare module "virtual:own-engine" {
    const engine: unknown;
    export default engine;
}

declare module "*.css" {}
