// Which platforms compute equal bits, the recorded hashes, and a comparison that the visitor's browser makes.

import Link from "@docusaurus/Link";
import Heading from "@theme/Heading";
import Layout from "@theme/Layout";
import { type ReactNode, useState } from "react";
import golden from "@site/generated/data/golden.json";
import expected from "@site/generated/data/pile.json";
import ScrollTable from "@site/src/components/ScrollTable";
import { BODIES, TAKEN, hashes } from "@site/src/live/pile.mjs";
import styles from "./determinism.module.css";

/** The platforms of crates/golden/everywhere.sh, and how each runs the scenes. */
const PLATFORMS = [
    { name: "x86-64, AVX2", runs: "1, 2, 3 and 8 threads" },
    { name: "x86-64, SSE2", runs: "1, 2, 3 and 8 threads" },
    { name: "aarch64, NEON", runs: "1 thread, under qemu" },
    { name: "WebAssembly, SIMD", runs: "1 thread, in Node.js" },
    { name: "WebAssembly, scalar", runs: "1 thread, in Node.js" },
];

const CRATES = [...new Set(golden.map(({ crate }) => crate))];
const SCENES = [...new Set(golden.map(({ scene }) => scene))];

function hashOf(crate: string, scene: string): string {
    return golden.find((entry) => entry.crate === crate && entry.scene === scene)?.hash ?? "";
}

type State = "idle" | "running" | "done" | "missing";

function Comparison(): ReactNode {
    const [state, setState] = useState<State>("idle");
    const [found, setFound] = useState<readonly string[]>([]);
    const run = async (): Promise<void> => {
        setState("running");
        const { loadPackage } = await import("@site/src/live/player");
        const engine = await loadPackage();
        // The message appears before the pile occupies the page.
        await new Promise((resolve) => setTimeout(resolve, 50));
        if (engine !== null) setFound(hashes(engine.module));
        setState(engine === null ? "missing" : "done");
    };
    const equal = found.length > 0 && found.every((hash, index) => hash === expected.hashes[index]);
    return (
        <>
            <button type="button" className="button button--primary" onClick={() => void run()} disabled={state === "running"}>
                Run {BODIES} bodies in this browser
            </button>
            <p className={styles.verdict} role="status">
                {state === "running" && "The pile runs …"}
                {state === "missing" && "This page was built without the engine."}
                {state === "done" && (equal ? "Equal bits: all hashes agree." : "The hashes differ: please report this browser.")}
            </p>
            <ScrollTable>
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

function Matrix(): ReactNode {
    return (
        <ScrollTable>
            <thead>
                <tr>
                    <th scope="col">platform</th>
                    <th scope="col">runs</th>
                    {CRATES.map((crate) => (
                        <th key={crate} scope="col">
                            {crate}
                        </th>
                    ))}
                </tr>
            </thead>
            <tbody>
                {PLATFORMS.map(({ name, runs }) => (
                    <tr key={name}>
                        <th scope="row">{name}</th>
                        <td>{runs}</td>
                        {CRATES.map((crate) => (
                            <td key={crate}>{golden.filter((entry) => entry.crate === crate).length} scenes equal</td>
                        ))}
                    </tr>
                ))}
            </tbody>
        </ScrollTable>
    );
}

export default function Determinism(): ReactNode {
    return (
        <Layout title="Determinism" description="Equal bits on every platform, with hashes and a comparison in the browser.">
            <main className="container margin-vert--lg">
                <h1>Determinism</h1>
                <p>
                    The same calls in the same order give the same bits on every machine. The{" "}
                    <Link to="/docs/guide/determinism">guide</Link> states the guarantee, its method and its limits.
                </p>
                <Heading as="h2" id="here">
                    In this browser
                </Heading>
                <p>
                    A pile of {BODIES} boxes and balls falls. Each hash covers position, rotation and velocity of every body, bit
                    by bit. Node.js computed the first column when this page was built.
                </p>
                <Comparison />
                <Heading as="h2" id="platforms">
                    Platforms
                </Heading>
                <p>
                    The script <code>crates/golden/everywhere.sh</code> runs {golden.length} scenes on each of these platforms,
                    and compares their hashes with the recorded ones. <code>cargo test -p golden</code> compares those of the
                    machine at hand.
                </p>
                <Matrix />
                <Heading as="h2" id="hashes">
                    Recorded hashes
                </Heading>
                <ScrollTable>
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
