"""Steps per second of batches of worlds, beside MuJoCo's `rollout`.

    pip install rapier mujoco matplotlib
    python python/benchmarks/rollout.py --chart rollout.png

Two scenes in both engines, with the same sizes, masses, time step and motors: the ant of `rapier.envs` on a plane, and a pile of boxes. Rapier computes in single
precision (`--double` for double precision), MuJoCo in double precision. Both use all cores. A line is the best of some repetitions.
"""

import argparse
import os
import time

import numpy as np

from rapier import dim3, dim3_f64

DT = 0.01
PILE = 20  # boxes
SETTLE = 150  # steps before a measurement: the pile lies, and the ant stands


def ant_world(engine):
    """The ant of the environments, at its initial pose."""
    from rapier.envs import ant

    world = engine.World(dt=DT)
    world.add_collider(engine.Shape.box([200, 0.5, 200]), position=[0, -0.5, 0], friction=1.0)
    _, joints = ant.add_ant(world)
    for joint in joints:
        joint.set_motor_position(0.0, ant.STIFFNESS, ant.DAMPING)
    return world


def pile_places():
    """Middles of the boxes: a loose heap."""
    rng = np.random.default_rng(1)
    return [np.array([*rng.uniform(-0.5, 0.5, 2), 0.4 + 0.45 * layer])[[0, 2, 1]] for layer in range(PILE)]


def pile_world(engine):
    """Boxes above a plane."""
    world = engine.World(dt=DT)
    world.add_collider(engine.Shape.box([50, 0.5, 50]), position=[0, -0.5, 0], friction=0.8)
    for place in pile_places():
        world.add_body(shape=engine.Shape.box([0.2, 0.2, 0.2]), position=place, density=500.0, friction=0.8, can_sleep=False)
    return world


def mujoco_ant():
    """The same ant for MuJoCo: z is up, and the motors are position servos with the same natural frequency."""
    from rapier.envs import ant

    legs, motors = [], []
    for number, (x, y) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)]):
        out = np.array([x, y]) / np.sqrt(2)
        hip, knee = ant.RADIUS * out, ant.UPPER * out
        foot = ant.LOWER * np.array([*(np.cos(ant.BENT) * out), -np.sin(ant.BENT)])
        size = f'size="{ant.THICKNESS}" density="200" contype="2" conaffinity="1"'
        legs.append(f"""<body pos="{hip[0]} {hip[1]} 0"><joint name="hip{number}" axis="0 0 1" range="{-ant.HIP} {ant.HIP}" limited="true"/>
            <geom type="capsule" fromto="0 0 0 {knee[0]} {knee[1]} 0" {size}/>
            <body pos="{knee[0]} {knee[1]} 0"><joint name="knee{number}" axis="{-out[1]} {out[0]} 0" range="{-ant.KNEE} {ant.KNEE}" limited="true"/>
            <geom type="capsule" fromto="0 0 0 {foot[0]} {foot[1]} {foot[2]}" {size}/></body></body>""")
        motors += [f'<position joint="{name}{number}" kp="40" kv="4"/>' for name in ("hip", "knee")]
    return f"""<mujoco><compiler angle="radian"/><option timestep="{DT}" integrator="implicitfast"/><worldbody>
        <geom type="box" size="200 200 0.5" pos="0 0 -0.5" friction="1" contype="1" conaffinity="2"/>
        <body pos="0 0 {ant.HEIGHT}"><freejoint/><geom type="sphere" size="{ant.RADIUS}" density="200" contype="2" conaffinity="1"/>{"".join(legs)}</body>
        </worldbody><actuator>{"".join(motors)}</actuator></mujoco>"""


def mujoco_pile():
    """The same pile for MuJoCo."""
    boxes = [
        f'<body pos="{x} {z} {y}"><freejoint/><geom type="box" size="0.2 0.2 0.2" density="500" friction="0.8"/></body>' for x, y, z in pile_places()
    ]
    return f"""<mujoco><option timestep="{DT}" integrator="implicitfast"/><worldbody><geom type="box" size="50 50 0.5" pos="0 0 -0.5" friction="0.8"/>
        {"".join(boxes)}</worldbody></mujoco>"""


def rapier_rate(world, engine, count, steps, repeats):
    """Steps of single worlds per second."""
    best, settled = 0.0, world.copy()
    settled.step(SETTLE)
    for _ in range(repeats):
        batch = engine.WorldBatch(settled, count)
        state = batch.state()
        batch.step()
        begin = time.perf_counter()
        for _ in range(steps):
            batch.step()
            batch.state(out=state)
        best = max(best, count * steps / (time.perf_counter() - begin))
    assert np.isfinite(state).all()
    return best


def mujoco_rate(text, count, steps, repeats):
    """The same with `mujoco.rollout` on all cores."""
    import mujoco
    from mujoco import rollout

    model = mujoco.MjModel.from_xml_string(text)
    threads = os.cpu_count() or 1
    data = [mujoco.MjData(model) for _ in range(threads)]
    mujoco.mj_step(model, data[0], SETTLE)
    full = mujoco.mjtState.mjSTATE_FULLPHYSICS
    initial = np.zeros(mujoco.mj_stateSize(model, full))
    mujoco.mj_getState(model, data[0], initial, full)
    initial, best = np.tile(initial, (count, 1)), 0.0
    with rollout.Rollout(nthread=threads) as runner:
        for _ in range(repeats):
            begin = time.perf_counter()
            states, _ = runner.rollout(model, data, initial, nstep=steps)
            best = max(best, count * steps / (time.perf_counter() - begin))
    assert np.isfinite(states).all()
    return best


def processor_times(world, text, steps):
    """Microseconds of the processor for a step of one world, in both engines: other programs do not disturb them."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(text)
    data, own = mujoco.MjData(model), world.copy()
    times = []
    for step in (own.step, lambda count: mujoco.mj_step(model, data, count)):
        step(SETTLE)
        begin = time.process_time()
        step(steps)
        times.append(1e6 * (time.process_time() - begin) / steps)
    return times


def chart(rows, path):
    """A bar for each engine, scene and number of worlds."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot

    scenes = list(dict.fromkeys(row[0] for row in rows))
    figure, axes = pyplot.subplots(1, len(scenes), figsize=(5 * len(scenes), 4), squeeze=False)
    for ax, scene in zip(axes[0], scenes):
        own = [row for row in rows if row[0] == scene]
        places = np.arange(len(own))
        ax.bar(places - 0.2, [row[2] for row in own], 0.4, label="rapier")
        ax.bar(places + 0.2, [row[3] for row in own], 0.4, label="MuJoCo rollout")
        ax.set_xticks(places, [f"{row[1]} worlds" for row in own])
        ax.set_title(scene)
        ax.set_ylabel("steps per second")
        ax.legend()
        ax.grid(axis="y", alpha=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description="Steps per second beside mujoco.rollout.")
    parser.add_argument("--worlds", type=int, nargs="+", default=[1, 64, 4096])
    parser.add_argument("--budget", type=int, default=60_000, help="steps of single worlds for each measurement, at least 30 and at most 3000 for each world")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--double", action="store_true", help="double precision for rapier")
    parser.add_argument("--substeps", type=int, default=4, help="of rapier; MuJoCo has none")
    parser.add_argument("--chart", help="file of a chart (PNG)")
    arguments = parser.parse_args()
    engine = dim3_f64 if arguments.double else dim3
    scenes = {"ant": (ant_world, mujoco_ant), "pile": (pile_world, mujoco_pile)}
    rows = []
    print(f"{os.cpu_count()} cores, steps of {DT} s, best of {arguments.repeats}")
    print(f"{'scene':6} {'worlds':>6} {'steps':>6} {'rapier/s':>12} {'mujoco/s':>12} {'ratio':>6}", flush=True)
    for name, (build, text) in scenes.items():
        world, model = build(engine), text()
        world.solver_iterations = arguments.substeps
        ours, theirs = processor_times(world, model, 2000)
        print(f"{name}: one world takes {ours:.1f} µs of the processor a step, in MuJoCo {theirs:.1f} µs", flush=True)
        for count in arguments.worlds:
            steps = int(np.clip(arguments.budget // count, 30, 3000))
            ours = rapier_rate(world, engine, count, steps, arguments.repeats)
            theirs = mujoco_rate(model, count, steps, arguments.repeats)
            rows.append((name, count, ours, theirs))
            print(f"{name:6} {count:6} {steps:6} {ours:12.0f} {theirs:12.0f} {ours / theirs:6.2f}", flush=True)
    if arguments.chart:
        chart(rows, arguments.chart)


if __name__ == "__main__":
    main()
