"""Formulas and articulated scenes in rapier, MuJoCo and PyBullet: error against the time of a step.

    pip install rapier mujoco pybullet matplotlib
    python python/benchmarks/fidelity.py --chart fidelity.png

Each test has an exact answer, or conserves energy. It runs with several lengths of the step, in one process on one core. An engine that is not installed is left out.
"""

import argparse
import time

import numpy as np
from engines import ENGINES, GRAVITY, Part, Scene

STEPS = (1 / 60, 1 / 240, 1 / 1000)


def rotate(quaternions, vectors):
    """Vectors turned by quaternions (x, y, z, w)."""
    axis, w = quaternions[..., :3], quaternions[..., 3:]
    turn = 2.0 * np.cross(axis, vectors)
    return vectors + w * turn + np.cross(axis, turn)


def energy(scene, states):
    """Kinetic and potential energy (J)."""
    total = 0.0
    for part, row in zip(scene.parts, states):
        conjugate = row[3:7] * [-1, -1, -1, 1]
        spin = rotate(conjugate, row[10:13])
        total += 0.5 * part.mass * row[7:10] @ row[7:10] + 0.5 * part.inertia @ np.square(spin) - part.mass * row[:3] @ np.array(scene.gravity)
    return total


def fall(engine, dt):
    """Free fall of 2 s: the distance, of 19.62 m."""
    world = engine(Scene([Part((0.5,), 1.0, (0, 100, 0))]), dt)
    world.step(round(2 / dt))
    return abs(100 - world.states()[0, 1] - 0.5 * GRAVITY * 4) / (0.5 * GRAVITY * 4)


def slide(engine, dt):
    """A box slides to a stop: v²/(2 µ g) = 10.8733 m."""
    world = engine(Scene([Part((0.5, 0.5, 0.5), 1.0, (0, 0.5, 0), linvel=(8, 0, 0))], plane=True, friction=0.3), dt)
    world.step(round(4 / dt))
    exact = 64 / (2 * 0.3 * GRAVITY)
    return abs(world.states()[0, 0] - exact) / exact


def roll(engine, dt):
    """A ball rolls down 20° for 2 s: a = 5/7 g sin θ."""
    angle = np.radians(20)
    gravity = (GRAVITY * np.sin(angle), -GRAVITY * np.cos(angle), 0.0)
    world = engine(Scene([Part((0.5,), 1.0, (0, 0.5, 0))], plane=True, friction=0.5, gravity=gravity), dt)
    world.step(round(2 / dt))
    exact = 0.5 * 5 / 7 * GRAVITY * np.sin(angle) * 4
    return abs(world.states()[0, 0] - exact) / exact


def tumble(engine, dt):
    """A free box turns about its middle axis for 20 s: energy."""
    scene = Scene([Part((1.0, 0.6, 0.2), 1.0, (0, 0, 0), angvel=(0.01, 5.0, 0.01))], gravity=(0.0, 0.0, 0.0))
    world = engine(scene, dt)
    begin = energy(scene, world.states())
    world.step(round(20 / dt))
    return abs(energy(scene, world.states()) - begin) / begin


def pendulum(engine, dt):
    """A pendulum of 1 m with an amplitude of 90°: the position after five periods of 2.36784 s."""
    part = Part((0.001,), 1.0, (1, 0, 0), joint="hinge")
    world = engine(Scene([part]), dt)
    period = 2 * np.pi * np.sqrt(1 / GRAVITY) / 0.847213084793979  # the arithmetic-geometric mean of 1 and cos 45°
    world.step(round(5 * period / dt))
    x, y, _ = world.states()[0, :3]
    return abs(np.arctan2(x, -y) - np.pi / 2)


def chain_of(count, joint="hinge"):
    """Boxes in a row along x, each held at its left end by the one before."""
    parts = []
    for number in range(count):
        parts.append(Part((0.25, 0.05, 0.05), 1.0, (0.25 + 0.5 * number, 0, 0), joint=joint, parent=number - 1, anchor=(0.5 * number, 0, 0)))
    return Scene(parts)


def drift(engine, dt, scene, seconds):
    """Largest relative change of the energy, relative to the largest potential energy."""
    world = engine(scene, dt)
    begin, largest = energy(scene, world.states()), 0.0
    scale = sum(part.mass for part in scene.parts) * GRAVITY
    for _ in range(round(10 * seconds)):
        world.step(round(0.1 / dt))
        # Not a number stays the largest.
        largest = np.maximum(largest, abs(energy(scene, world.states()) - begin))
    return largest / scale


def double_pendulum(engine, dt):
    """Two links for 10 s: energy."""
    return drift(engine, dt, chain_of(2), 10)


def hinge_chain(engine, dt):
    """Ten links with hinges for 5 s: energy."""
    return drift(engine, dt, chain_of(10), 5)


def ball_chain(engine, dt):
    """Six links with ball joints, pushed to the side by their weight alone, for 5 s: energy."""
    return drift(engine, dt, chain_of(6, "ball"), 5)


def cart(engine, dt):
    """A pole falls on a free cart for 5 s: energy."""
    parts = [
        Part((0.2, 0.1, 0.1), 1.0, (0, 0, 0), joint="slide", axis=(1.0, 0.0, 0.0)),
        Part((0.03, 0.5, 0.03), 0.3, (0.5 * np.sin(0.3), 0.5 * np.cos(0.3), 0), joint="hinge", parent=0),
    ]
    return drift(engine, dt, Scene(parts), 5)


def top(engine, dt):
    """A fast top on a ball joint for 5 s: precession of m g r / (I ω) = 0.3924 rad/s."""
    arm, spin, radius = 0.2, 40.0, 0.5
    # A ball has the moment 0.4 m r² about its axis.
    part = Part((radius,), 1.0, (arm, 0, 0), joint="ball", angvel=(spin, 0.0, 0.0))
    world = engine(Scene([part]), dt)
    world.step(round(5 / dt))
    x, _, z = world.states()[0, :3]
    exact = GRAVITY * arm / (0.4 * radius**2 * spin)
    return abs(np.arctan2(-z, x) / 5 - exact) / exact


FORMULAS = [fall, slide, roll, tumble, pendulum]
ARTICULATED = [double_pendulum, hinge_chain, ball_chain, cart, top]


def available():
    """The engines that are installed."""
    found = []
    for engine in ENGINES:
        try:
            engine(Scene([Part((0.5,), 1.0, (0, 1, 0))]), 0.01).step(1)
            found.append(engine)
        except ImportError as error:
            print(f"{engine.name} is left out: {error}")
    return found


def measure(engine, test, dt):
    """The error of a test, and the seconds of the processor for a step in it: other programs do not disturb them."""
    total = {"seconds": 0.0, "steps": 0}

    class Timed(engine):
        def step(self, count):
            begin = time.process_time()
            super().step(count)
            total["seconds"] += time.process_time() - begin
            total["steps"] += count

    error = test(Timed, dt)
    return error, total["seconds"] / total["steps"]


#: Tests of the chart, and what their error measures. The table has all tests.
CHARTED = {"slide": "a box slides to a stop: distance", "tumble": "a box tumbles: energy", "hinge_chain": "a chain of ten hinges: energy", "top": "a fast top: precession"}
#: Marker and colour of each engine; the colours differ for colour-blind readers too.
STYLES = {"rapier f32": ("s", "#0072B2"), "rapier f64": ("D", "#56B4E9"), "MuJoCo": ("^", "#D55E00"), "MuJoCo RK4": ("v", "#E69F00"), "PyBullet": ("o", "#009E73")}


def errors(ratio):
    """How a peer's error compares with this one, in words."""
    if ratio >= 1000:
        return "over 1,000 times less error"
    return f"{ratio:.3g} times less error" if ratio >= 1 else f"{1 / ratio:.3g} times more error"


def chart(rows, engines, path):
    """Error against the time of a step, a panel for each charted test. The headings compare with MuJoCo's default at 240 Hz."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot

    figure, panels = pyplot.subplots(2, 2, figsize=(11, 8))
    for panel, (test, title) in zip(panels.flat, CHARTED.items()):
        for engine in engines:
            own = [(seconds * 1e6, max(error, 1e-9)) for name, other, _, error, seconds in rows if name == test and other == engine.name]
            marker, color = STYLES[engine.name]
            panel.loglog(*zip(*own), marker=marker, color=color, label=engine.name)
        (error, seconds), (peer_error, peer_seconds) = [
            next(row[3:] for row in rows if row[0] == test and row[1] == name and abs(row[2] - 1 / 240) < 1e-9) for name in ("rapier f64", "MuJoCo")
        ]
        result = f"{errors(peer_error / error)} than MuJoCo, {seconds / peer_seconds:.2g} times its time"
        panel.set_title(f"{title}\n{result}", fontsize=11, loc="left")
        panel.grid(alpha=0.3)
        panel.set_xticks([1, 2, 5, 10, 20, 50, 100], [1, 2, 5, 10, 20, 50, 100])
        panel.set_xticks([], minor=True)
        panel.set_xlim(1, 110)
        panel.set_xlabel("processor time of a step (µs)")
        panel.set_ylabel("error")
    panels[0, 0].annotate("better", xy=(0.03, 0.04), xytext=(0.16, 0.17), xycoords="axes fraction", arrowprops={"arrowstyle": "->"})
    panels[0, 1].legend(fontsize=9)
    figure.suptitle("Errors and times with steps of 1/60, 1/240 and 1/1000 s: lower left is better")
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description="Errors of formulas and of articulated scenes in three engines.")
    parser.add_argument("--chart", help="file of a chart (PNG)")
    arguments = parser.parse_args()
    engines, rows = available(), []
    print(f"{'test':16} {'step':>8} " + " ".join(f"{engine.name:>22}" for engine in engines))
    for test in FORMULAS + ARTICULATED:
        for dt in STEPS:
            cells = []
            for engine in engines:
                error, seconds = measure(engine, test, dt)
                rows.append((test.__name__, engine.name, dt, error, seconds))
                cells.append(f"{error:11.2e} {1e6 * seconds:7.1f} µs")
            print(f"{test.__name__:16} {f'1/{round(1 / dt)}':>8} " + " ".join(f"{cell:>22}" for cell in cells), flush=True)
    if arguments.chart:
        chart(rows, engines, arguments.chart)


if __name__ == "__main__":
    main()
