// The benchmark tables as charts.

import Link from "@docusaurus/Link";
import Heading from "@theme/Heading";
import Layout from "@theme/Layout";
import type { ReactNode } from "react";
import ContestChart from "@site/src/charts/ContestChart";
import GrowthChart from "@site/src/charts/GrowthChart";
import LeadChart from "@site/src/charts/LeadChart";
import PackageTable from "@site/src/charts/PackageTable";
import { CONDITIONS, MACHINE } from "@site/src/charts/contests";

export default function Benchmarks(): ReactNode {
    return (
        <Layout title="Benchmarks" description="Times, memory and accuracy of the engine beside its peers.">
            <main className="container margin-vert--lg markdown">
                <h1>Benchmarks</h1>
                <p>
                    {MACHINE} {CONDITIONS} The charts of native engines show the tables that the benchmark program writes. These{" "}
                    <Link to="/docs/benchmarks/latest">tables</Link> have more columns, and list the scenes in which engines have
                    different contacts. Times depend on the machine: <code>cargo run --release -p bench</code> measures others.
                </p>
                <Heading as="h2" id="lead">
                    Lead
                </Heading>
                <p>Time of the fastest peer divided by this engine's time: to the right of the line this engine is faster.</p>
                <div className="row">
                    <div className="col col--6">
                        <LeadChart dimension="3d" />
                    </div>
                    <div className="col col--6">
                        <LeadChart dimension="2d" />
                    </div>
                </div>
                <Heading as="h2" id="scenes">
                    Scenes
                </Heading>
                <ContestChart />
                <Heading as="h2" id="growth">
                    Growth
                </Heading>
                <GrowthChart />
                <p>
                    <Link to="/docs/benchmarks/growth">All curves and their tables</Link>
                </p>
                <Heading as="h2" id="javascript">
                    JavaScript
                </Heading>
                <p>
                    The packages beside others, in Node.js. The figures are entered by hand from the output of{" "}
                    <code>npm run bench</code> in <code>javascript/peers</code>.{" "}
                    <Link to="/docs/benchmarks/javascript">Conditions, browsers and sizes</Link>
                </p>
                <PackageTable title="3D, Node.js" />
                <PackageTable title="2D, Node.js" />
            </main>
        </Layout>
    );
}
