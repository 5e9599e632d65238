// Serves a build as a static host does: index.html of folders, and 404.html for unknown addresses.

import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript",
    ".css": "text/css",
    ".json": "application/json",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".webp": "image/webp",
    ".wasm": "application/wasm",
    ".xml": "application/xml",
};

function fileOf(build, url) {
    const path = join(build, normalize(decodeURIComponent(new URL(url, "http://localhost").pathname)));
    return existsSync(path) && statSync(path).isDirectory() ? join(path, "index.html") : path;
}

/** Starts a server on a free port. */
export async function serve(build) {
    const server = createServer((request, response) => {
        const path = fileOf(build, request.url);
        const found = existsSync(path);
        const shown = found ? path : join(build, "404.html");
        response.writeHead(found ? 200 : 404, { "content-type": TYPES[extname(shown)] ?? "application/octet-stream" });
        createReadStream(shown).pipe(response);
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    return { address: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}
