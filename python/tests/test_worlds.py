"""Worlds: motion against formulas, copies and snapshots against the run without them."""

import copy
import pickle
import threading

import numpy as np
import pytest
from conftest import at, make_ground, make_pile, turned

import rapier


def test_a_body_falls_by_the_formula(engine):
    world = engine.World()
    body = world.add_body(shape=engine.Shape.ball(0.5), position=at(engine, 0, 100), can_sleep=False)
    world.step(60)
    # Steps of 1/60 s: the error of the position is at most g t dt / 2.
    assert body.position[1] == pytest.approx(100 - 0.5 * 9.81, abs=0.5 * 9.81 / 60 + 1e-4)
    assert body.linvel[1] == pytest.approx(-9.81, rel=1e-5)


def test_gravity_is_that_of_the_world(engine):
    world = engine.World(gravity=at(engine, 3, 0), dt=0.01)
    assert world.gravity == pytest.approx(at(engine, 3, 0))
    body = world.add_body(shape=engine.Shape.ball(0.5))
    world.step(100)
    assert body.linvel[0] == pytest.approx(3.0, rel=1e-5)


@pytest.mark.parametrize("friction, slides", [(0.8, False), (0.2, True)])
def test_a_box_holds_on_a_slope_below_the_friction_angle(engine, friction, slides):
    angle = 0.4  # tan = 0.42
    world = engine.World(gravity=at(engine, -9.81 * np.sin(angle), -9.81 * np.cos(angle)))
    world.add_collider(engine.Shape.halfspace(at(engine, 0, 1)), friction=friction)
    body = world.add_body(shape=engine.Shape.box(at(engine, 0.5, 0.5, 0.5)), position=at(engine, 0, 0.5), friction=friction)
    world.step(120)
    way = -0.5 * 9.81 * (np.sin(angle) - friction * np.cos(angle)) * 4 if slides else 0.0
    assert body.position[0] == pytest.approx(way, abs=0.05 + 0.02 * abs(way))


def test_a_pendulum_keeps_its_length_and_its_energy(engine):
    world = engine.World(dt=1 / 240)
    pivot = world.add_body("fixed")
    bob = world.add_body(shape=engine.Shape.ball(0.1), position=at(engine, 1, 0), can_sleep=False)
    joint = {"axis": [0, 0, 1]} if engine.DIM == 3 else {}
    world.add_joint("revolute", pivot, bob, anchor2=at(engine, -1, 0), **joint)
    for _ in range(10):
        world.step(24)
        assert np.linalg.norm(bob.position) == pytest.approx(1.0, abs=1e-3)
        energy = bob.kinetic_energy + bob.mass * 9.81 * bob.position[1]
        assert energy == pytest.approx(0.0, abs=0.02 * bob.mass * 9.81)


def test_a_motor_reaches_its_target_and_stops_at_its_limit(engine):
    world = engine.World(gravity=at(engine, 0, 0))
    base = world.add_body("fixed")
    arm = world.add_body(shape=engine.Shape.box(at(engine, 0.5, 0.1, 0.1)), can_sleep=False)
    options = {"axis": [0, 0, 1]} if engine.DIM == 3 else {}
    joint = world.add_joint("revolute", base, arm, limits=(-0.5, 0.5), **options)

    def angle():
        return arm.rotation if engine.DIM == 2 else 2 * np.arctan2(arm.rotation[2], arm.rotation[3])

    joint.set_motor_position(0.3, stiffness=100, damping=20)
    world.step(240)
    assert angle() == pytest.approx(0.3, abs=1e-2)
    joint.set_motor_velocity(2.0, factor=10)
    world.step(240)
    assert angle() == pytest.approx(0.5, abs=2e-2)


def test_a_kinematic_body_carries_what_lies_on_it(engine):
    world = make_ground(engine)
    lift = world.add_body("kinematic_velocity", engine.Shape.box(at(engine, 2, 0.5, 2)), position=at(engine, 0, 0.5), linvel=at(engine, 0, 1))
    load = world.add_body(shape=engine.Shape.box(at(engine, 0.5, 0.5, 0.5)), position=at(engine, 0, 1.5))
    world.step(120)
    assert lift.position[1] == pytest.approx(2.5, abs=1e-3)
    assert load.position[1] == pytest.approx(3.5, abs=2e-2)


def test_collisions_are_reported_with_their_colliders(engine):
    world = engine.World()
    ground = world.add_collider(engine.Shape.halfspace(at(engine, 0, 1)))
    ball = world.add_body(shape=engine.Shape.ball(0.5), position=at(engine, 0, 2), events=True)
    world.step(120)
    (event,) = world.collision_events()
    assert event.started and not event.sensor
    assert {event.collider1, event.collider2} == {ground, ball.colliders[0]}
    assert ball.colliders[0].touching == [ground]
    ball.position = at(engine, 0, 10)
    world.step()
    (event,) = world.collision_events()
    assert not event.started
    assert world.collision_events() == []


def test_state_has_a_row_for_each_body(engine):
    world = make_pile(engine, 5)
    world.step(3)
    state = world.state()
    assert state.shape == (5, engine.STATE) and state.dtype == engine.dtype
    for body, row in zip(world.bodies, state):
        assert np.array_equal(row[: engine.DIM], body.position)
        rotation = np.atleast_1d(body.rotation)
        assert np.array_equal(row[engine.DIM : engine.DIM + len(rotation)], rotation.astype(engine.dtype))
    out = np.empty_like(state)
    assert world.state(out=out) is out
    assert np.array_equal(out, state)


@pytest.mark.parametrize("way", ["snapshot", "pickle", "copy", "deepcopy"])
def test_a_copy_continues_bit_by_bit(engine, way):
    world = make_pile(engine)
    world.step(40)
    copies = {
        "snapshot": lambda: engine.World.from_snapshot(world.snapshot()),
        "pickle": lambda: pickle.loads(pickle.dumps(world)),
        "copy": world.copy,
        "deepcopy": lambda: copy.deepcopy(world),
    }
    other = copies[way]()
    for _ in range(40):
        world.step()
        other.step()
        assert world.hash == other.hash
    assert np.array_equal(world.state(), other.state())


def test_damaged_snapshots_are_refused(engine):
    world = make_pile(engine, 3)
    snapshot = world.snapshot()
    flipped = bytearray(snapshot)
    flipped[len(flipped) // 2] ^= 1
    for damaged in [b"", snapshot[:-1], bytes(flipped)]:
        with pytest.raises(rapier.SnapshotError):
            engine.World.from_snapshot(damaged)
    other = rapier.dim3 if engine.DIM == 2 else rapier.dim2
    with pytest.raises(rapier.SnapshotError):
        other.World.from_snapshot(snapshot)


def test_a_step_releases_the_lock_of_the_interpreter():
    world = make_pile(rapier.dim3, 400)
    done = threading.Event()

    def run():
        world.step(60)
        done.set()

    thread = threading.Thread(target=run)
    thread.start()
    turns = 0
    while not done.is_set():
        turns += 1
    thread.join()
    # With the lock held, the thread would end before this one's second turn.
    assert turns > 1000


def test_a_thread_that_waits_for_a_world_stops_no_other():
    world = make_pile(rapier.dim3, 400)
    body = world.bodies[0]
    stepping, reading, done = threading.Event(), threading.Event(), threading.Event()

    def step():
        stepping.set()
        world.step(60)
        done.set()

    def read():
        stepping.wait()
        reading.set()
        while not done.is_set():
            assert body.alive

    threads = [threading.Thread(target=step), threading.Thread(target=read)]
    for thread in threads:
        thread.start()
    reading.wait()
    turns = 0
    while not done.is_set():
        turns += 1
    for thread in threads:
        thread.join()
    # With the interpreter's lock held by the reader, this thread would run only after the step.
    assert turns > 10_000


def test_joints_are_keys(engine):
    world = engine.World()
    joint, other = (world.add_joint("fixed", world.add_body(), world.add_body()) for _ in range(2))
    assert {joint: 1, other: 2}[joint] == 1 and joint != other


def test_a_kinematic_body_moves_to_a_pose_given_in_two_calls(engine):
    world = engine.World()
    body = world.add_body("kinematic_position", position=at(engine, 1, 2))
    body.move_to(at(engine, 1.5, 2))
    body.move_to(rotation=turned(engine, 0.25))
    world.step()
    assert body.position == pytest.approx(at(engine, 1.5, 2), abs=1e-6)
    assert body.rotation == pytest.approx(turned(engine, 0.25), abs=1e-6)


def test_debug_lines_show_a_box(engine):
    world = engine.World()
    world.add_body(shape=engine.Shape.box(at(engine, 1, 2, 3)))
    lines, colors = world.debug_lines()
    assert lines.shape == (12 if engine.DIM == 3 else 4, 2, engine.DIM) and colors.shape == (len(lines), 4)
    assert np.abs(lines).max(axis=(0, 1)) == pytest.approx(at(engine, 1, 2, 3))


def test_a_turned_body_has_the_rotation_that_it_was_given(engine):
    world = engine.World()
    body = world.add_body(rotation=turned(engine, 0.5))
    assert body.rotation == pytest.approx(turned(engine, 0.5), abs=1e-6)
