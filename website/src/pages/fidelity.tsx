// Errors against formulas as charts.

import Link from "@docusaurus/Link";
import Layout from "@theme/Layout";
import type { ReactNode } from "react";
import FidelityCharts from "@site/src/charts/FidelityCharts";

export default function Fidelity(): ReactNode {
    return (
        <Layout title="Fidelity" description="Errors of the engine against formulas of mechanics, and how they shrink with the step.">
            <main className="container margin-vert--lg markdown">
                <h1>Fidelity</h1>
                <p>
                    The engine&apos;s tests compare worlds with formulas of mechanics. Each chart shows the largest relative error of one
                    law at 30, 60 and 240 steps a second. Where the continuous motion is known, the error is the distance from it, and
                    shrinks with the step. Elsewhere the formula includes the step, and the error is rounding and the rest of the
                    solver&apos;s accuracy. Errors below 0.0001 % are drawn at that line.
                </p>
                <p>
                    <Link to="/docs/fidelity">All laws and figures</Link>, stability and energy included; <code>cargo run -p fidelity</code>{" "}
                    measures them.
                </p>
                <FidelityCharts />
            </main>
        </Layout>
    );
}
