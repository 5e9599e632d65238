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
                    The engine&apos;s tests compare worlds with formulas of mechanics. Each chart shows the largest relative error of all
                    rows of one table, over the steps a second. Where the table has an exact value of the continuous motion, the error is
                    the distance from it, otherwise the distance from the formula. Errors below the last printed digit are drawn at that
                    digit. Where curves are equal, the last one of the legend covers the others.
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
