#!/usr/bin/env bash
# Uses the packed npm packages as a user would: npm.sh [2] [3]
#
# A folder outside the repository gets the tarball of target/artefacts/npm and the tools of a user: Vite, TypeScript, publint and
# arethetypeswrong. The programs run in Node.js as modules, CommonJS and worker, and in Chromium from Vite's development server and
# build. Without Chromium (CHROMIUM names another one) the rows of pages say so.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. crates/release/try/lib.sh
artefacts=$PWD/target/artefacts/npm
chromium=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
user=$(mktemp -d)
trap 'rm -rf "$user"' EXIT

# project DIMENSION TARBALL: a project whose only dependency is the tarball.
project() {
    local name=rapier${1}d at3
    [ "$1" = 3 ] && at3=', 0' || at3=
    mkdir -p "$user/$name/src"
    cd "$user/$name"
    cat >package.json <<TEXT
{
    "private": true, "type": "module",
    "dependencies": { "$name": "file:$2" },
    "devDependencies": {
        "@arethetypeswrong/cli": "0.18.5", "playwright-core": "1.65.1", "publint": "0.3.25", "typescript": "6.0.3", "typescript5": "npm:typescript@5.9.3", "vite": "8.3.8"
    }
}
TEXT
    local steps='const world = new RAPIER.PhysicsWorld();
    world.insert(RAPIER.RigidBodyDesc.fixed(), RAPIER.ColliderDesc.cuboid(9, 1'${at3/0/9}'));
    const [ball] = world.insert(RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 4'$at3'), RAPIER.ColliderDesc.ball(0.5));
    for (let step = 0; step < 200; step += 1) world.step();
    if (Math.abs(ball.translation().y - 1.5) > 0.01) throw new Error(`the ball is at ${ball.translation().y}`);'
    cat >main.mjs <<TEXT
import RAPIER from "$name";
await RAPIER.init();
$steps
TEXT
    cat >main.cjs <<TEXT
const RAPIER = require("$name");
RAPIER.init().then(() => {
    $steps
});
TEXT
    cat >worker.mjs <<TEXT
import { Worker, isMainThread, parentPort } from "node:worker_threads";
import RAPIER from "$name";
if (isMainThread) {
    const worker = new Worker(new URL(import.meta.url));
    const message = await new Promise((resolve, reject) => worker.once("message", resolve).once("error", reject));
    if (message !== "done") throw new Error(message);
} else {
    await RAPIER.init();
    $steps
    parentPort.postMessage("done");
}
TEXT
    cat >src/worker.js <<TEXT
import RAPIER from "$name";
RAPIER.init().then(() => {
    $steps
    postMessage("done");
});
TEXT
    cat >src/main.js <<TEXT
import RAPIER from "$name";
async function run() {
    await RAPIER.init();
    $steps
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    return await new Promise((resolve, reject) => ((worker.onmessage = ({ data }) => resolve(data)), (worker.onerror = reject)));
}
run().then((text) => (document.body.dataset.result = text), (error) => (document.body.dataset.result = String(error)));
TEXT
    printf '<!doctype html><link rel="icon" href="data:,"><body><script type="module" src="./src/main.js"></script>\n' >index.html
    cat >visit.mjs <<'TEXT'
// visit.mjs CHROMIUM dev|preview: starts Vite, and expects "done" as the result of its page.
import { chromium } from "playwright-core";
import { createServer, preview } from "vite";
const [executablePath, kind] = process.argv.slice(2);
const options = { configFile: false, logLevel: "warn" };
const server = kind === "dev" ? await (await createServer(options)).listen() : await preview(options);
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const tab = await browser.newPage();
tab.on("console", (message) => console.log(message.text()));
await tab.goto(server.resolvedUrls.local[0]);
await tab.waitForFunction(() => document.body.dataset.result, null, { timeout: 120_000 });
const result = await tab.evaluate(() => document.body.dataset.result);
console.log(result);
process.exit(result === "done" ? 0 : 1);
TEXT
    # A strict program. Its first line selects the kind of its module.
    local body='
async function run(): Promise<number> {
    await RAPIER.init();
    const world: RAPIER.World = new RAPIER.PhysicsWorld();
    const body: RAPIER.RigidBody = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
    const collider: RAPIER.Collider = world.createCollider(RAPIER.ColliderDesc.ball(0.5), body);
    const hit: RAPIER.RayColliderHit | null = world.castRay(new RAPIER.Ray(body.translation(), body.linvel()), 1, true);
    return (hit?.timeOfImpact ?? 0) + collider.friction();
}
export { run };'
    printf 'import RAPIER from "%s";%s\n' "$name" "$body" >strict.mts
    printf 'import RAPIER = require("%s");%s\n' "$name" "$body" >strict.cts
    printf 'import RAPIER from "%s";%s\n' "$name" "$body" >strict.ts
}

# check TYPESCRIPT RESOLUTION MODULE FILE…: a strict check, libraries included.
check() {
    local compiler=$1 resolution=$2 module=$3
    shift 3
    node "node_modules/$compiler/bin/tsc" --strict --noEmit --skipLibCheck false --exactOptionalPropertyTypes --noUncheckedIndexedAccess --target es2022 \
        --lib es2022,dom,esnext.disposable --esModuleInterop --moduleResolution "$resolution" --module "$module" "$@"
}

# wrong_types TARBALL: asks arethetypeswrong. node10 knows no exports, so it finds the first entry alone. The CommonJS entry has all names
# and a default, as its definitions state: `export =` could not have both. `file` is an entry for pages, which have no `require`.
wrong_types() {
    node_modules/.bin/attw --profile node16 --entrypoints . compat --ignore-rules missing-export-equals --format ascii "$1"
    node_modules/.bin/attw --profile esm-only --entrypoints file --format ascii "$1"
}

visit() { node visit.mjs "$chromium" "$1"; }

build_and_visit() { node_modules/.bin/vite build --logLevel warn && visit preview; }

readme() { awk '/^```js/ { inside = 1; next } /^```/ { if (inside) exit } inside' "node_modules/$1/README.md" >readme.mjs && [ -s readme.mjs ] && node readme.mjs; }

heading
for dimension in ${*:-2 3}; do
    name=rapier${dimension}d
    tarball=$(echo "$artefacts/$name"-*.tgz)
    project "$dimension" "$tarball"
    row "\`$name\`: install of the tarball" npm install --no-fund --no-audit --loglevel=error
    row "\`$name\`: program of the README" readme "$name"
    row "\`$name\`: Node.js, module" node main.mjs
    row "\`$name\`: Node.js, CommonJS" node main.cjs
    row "\`$name\`: Node.js, worker" node worker.mjs
    row "\`$name\`: \`tsc --strict\`, \`node16\`, module and CommonJS" check typescript node16 node16 strict.mts strict.cts
    row "\`$name\`: \`tsc --strict\`, \`bundler\`" check typescript bundler esnext strict.ts
    row "\`$name\`: \`tsc --strict\`, \`node10\` (TypeScript 5)" check typescript5 node10 esnext strict.ts
    if [ -n "$chromium" ]; then
        row "\`$name\`: Vite, development, page and worker" visit dev
        row "\`$name\`: Vite, build, page and worker" build_and_visit
    else
        printf '| `%s`: Vite | not run: no Chromium | |\n' "$name"
    fi
    row "\`$name\`: publint" node_modules/.bin/publint --strict "$tarball"
    row "\`$name\`: arethetypeswrong" wrong_types "$tarball"
done
exit "$failures"
