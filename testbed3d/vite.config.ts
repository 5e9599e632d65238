import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { configure } from "../testbed/tools/vite.ts";

export default defineConfig(configure(dirname(fileURLToPath(import.meta.url)), 3));
