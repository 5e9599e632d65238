// The platforms whose bits are compared, the recorded hashes, and a comparison that the visitor's browser makes.

import Link from "@docusaurus/Link";
import Heading from "@theme/Heading";
import Layout from "@theme/Layout";
import { type ReactNode, useState } from "react";
import golden from "@site/generated/data/golden.json";
import expected from "@site/generated/data/pile.json";
import platforms from "@site/generated/data/platforms.json";
import ScrollTable from "@site/src/components/ScrollTable";
import { BODIES, TAKEN, hashes } from "@site/src/live/pile.mjs";
import styles from "./determinism.module.css";

/** Platform and runs by argument of crates/golden/everywhere.sh. */
const RUNS: Readonly<Record<string, readonly [platform: string, runs: string]>> = {
    native: ["processor of the machine", "1, 2, 3 and 8 threads, each with the widest registers and with the baseline's"],
    "wasm-simd": ["WebAssembly with SIMD", "1 thread, in Node.js"],
    "wasm-scalar": ["WebAssembly without SIMD", "1 thread, in Node.js"],
    aarch64: ["aarch64 Linux", "1 thread, under qemu"],
    i686: ["i686 Linux", "1 thread, under qemu"],
    armv7: ["armv7 Linux", "1 thread, under qemu"],
    riscv64: ["riscv64 Linux", "1 thread, under qemu"],
    s390x: ["s390x Linux, big-endian", "1 thread, under qemu"],
};

const CRATES = [...new Set(golden.map(({ crate }) => crate))];
const SCENES = [...new Set(golden.map(({ scene }) => scene))];

function hashOf(crate: string, scene: string): string {
    return golden.find((entry) => entry.crate === crate && entry.scene === scene)?.hash ?? "";
}

function runsOf(argument: string): readonly [platform: string, runs: string] {
    const found = RUNS[argument];
    if (found === undefined) throw new RangeError(`crates/golden/everywhere.sh has a new platform "${argument}"`);
    return found;
}

type State = "idle" | "running" | "done" | "missing" | "failed";

function Comparison(): ReactNode {
    const [state, setState] = useState<State>("idle");
    const [found, setFound] = useState<readonly string[]>([]);
    const [problem, setProblem] = useState("");
    const run = async (): Promise<void> => {
        const { loadPackage } = await import("@site/src/live/package");
        const engine = await loadPackage();
        // The message appears before the pile occupies the page.
        await new Promise((resolve) => setTimeout(resolve, 50));
        if (engine !== null) setFound(hashes(engine.module));
        setState(engine === null ? "missing" : "done");
    };
    const start = (): void => {
        setState("running");
        run().catch((error: unknown) => {
            setProblem(error instanceof Error ? error.message : String(error));
            setState("failed");
        });
    };
    const equal = found.length > 0 && found.every((hash, index) => hash === expected.hashes[index]);
    return (
        <>
            <button type="button" className="button button--primary" onClick={start} disabled={state === "running"}>
                Run {BODIES} bodies in this browser
            </button>
            <p className={styles.verdict} role="status">
                {state === "running" && "The pile runs …"}
                {state === "missing" && "This page was built without the engine."}
                {state === "failed" && `The pile did not run: ${problem}`}
                {state === "done" && (equal ? "Equal bits: all hashes agree." : "The hashes differ: please report this browser.")}
            </p>
            <ScrollTable label="Hashes of the pile">
                <thead>
                    <tr>
                        <th scope="col">after step</th>
                        <th scope="col">Node.js at build time ({expected.platform})</th>
                        <th scope="col">this browser</th>
                    </tr>
                </thead>
                <tbody>
                    {TAKEN.map((step, index) => (
                        <tr key={step}>
                            <th scope="row">{step}</th>
                            <td>
                                <code>{expected.hashes[index]}</code>
                            </td>
                            <td>
                                <code>{found[index] ?? "–"}</code>
                            </td>
                        </tr>
                    ))}
                </tbody>
            </ScrollTable>
        </>
    );
}

function Platforms(): ReactNode {
    return (
        <ScrollTable label="Platforms">
            <thead>
                <tr>
                    <th scope="col">platform</th>
                    <th scope="col">runs</th>
                    <th scope="col">command</th>
                </tr>
            </thead>
            <tbody>
                {platforms.map((argument) => {
                    const [platform, runs] = runsOf(argument);
                    return (
                        <tr key={argument}>
                            <th scope="row">{platform}</th>
                            <td>{runs}</td>
                            <td>
                                <code>crates/golden/everywhere.sh {argument}</code>
                            </td>
                        </tr>
                    );
                })}
            </tbody>
        </ScrollTable>
    );
}

export default function Determinism(): ReactNode {
    return (
        <Layout title="Determinism" description="Equal bits on x86-64, ARM, RISC-V and WebAssembly, with hashes and a comparison in the browser.">
            <main className="container margin-vert--lg">
                <h1>Determinism</h1>
                <p>
                    The same calls in the same order give the same bits on every little-endian machine. The{" "}
                    <Link to="/docs/guide/determinism">guide</Link> states the guarantee, its method and its limits.
                </p>
                <Heading as="h2" id="here">
                    In this browser
                </Heading>
                <p>
                    A pile of {BODIES} boxes and balls falls. Each hash covers all bodies, colliders, joints and pairs, bit
                    by bit. Node.js computed the first column when this page was built.
                </p>
                <Comparison />
                <Heading as="h2" id="platforms">
                    Platforms
                </Heading>
                <p>
                    The repository has the hashes of {golden.length} recorded scenes: {SCENES.length} for each of {CRATES.length}{" "}
                    crates. <code>crates/golden/everywhere.sh</code> runs them on these platforms, prints the scenes whose hashes
                    differ, and names the platforms that a machine cannot run. <Link to="/docs/platforms">Platforms</Link> has the last runs.
                </p>
                <Platforms />
                <Heading as="h2" id="hashes">
                    Recorded hashes
                </Heading>
                <ScrollTable label="Recorded hashes">
                    <thead>
                        <tr>
                            <th scope="col">scene</th>
                            {CRATES.map((crate) => (
                                <th key={crate} scope="col">
                                    {crate}
                                </th>
                            ))}
                        </tr>
                    </thead>
                    <tbody>
                        {SCENES.map((scene) => (
                            <tr key={scene}>
                                <th scope="row">{scene}</th>
                                {CRATES.map((crate) => (
                                    <td key={crate}>
                                        <code>{hashOf(crate, scene)}</code>
                                    </td>
                                ))}
                            </tr>
                        ))}
                    </tbody>
                </ScrollTable>
            </main>
        </Layout>
    );
}
