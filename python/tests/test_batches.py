"""Batches: each world gives the bits that it gives alone."""

import numpy as np
import pytest
from conftest import at, make_pile

import rapier


def test_a_batch_gives_the_bits_of_single_worlds(engine):
    world = make_pile(engine)
    batch = engine.WorldBatch(world, 5)
    state = batch.state()
    state[:, :, engine.DIM + (1 if engine.DIM == 2 else 4)] += np.arange(5)[:, None]  # velocities along x
    batch.set_state(state)
    single = [batch.world(index) for index in range(5)]
    batch.step(60)
    for index, world in enumerate(single):
        world.step(60)
        assert batch.hashes()[index] == world.hash
        assert np.array_equal(batch.state()[index], world.state())
    assert len(set(batch.hashes())) == 5


def test_a_reset_returns_the_selected_worlds(engine):
    world = make_pile(engine)
    world.step(10)
    batch = engine.WorldBatch(world, 3)
    batch.step(20)
    moved = batch.hashes()
    batch.reset([True, False, True])
    hashes = batch.hashes()
    assert hashes[0] == hashes[2] == world.hash and hashes[1] == moved[1]
    batch.step(20)
    assert batch.hashes()[0] == moved[0]


@pytest.mark.parametrize("mask", [np.array([True, False, True]), np.repeat([True, False, True], 2)[::2], [True, False, True], (True, False, True)])
def test_masks_are_arrays_or_sequences_of_booleans(engine, mask):
    batch = engine.WorldBatch(make_pile(engine, 3), 3)
    begin = batch.hashes()
    batch.step(5)
    moved = batch.hashes()
    batch.reset(mask)
    assert np.array_equal(batch.hashes(), np.where(np.asarray(mask), begin, moved))


@pytest.mark.parametrize("mask", [np.array([1.0, 0.0, 1.0]), np.array([2, 0, 1]), "yes", [1.5, 0, 1]])
def test_masks_of_other_types_are_refused(engine, mask):
    batch = engine.WorldBatch(make_pile(engine, 3), 3)
    batch.step(5)
    moved = batch.hashes()
    with pytest.raises((TypeError, rapier.InvalidValueError)):
        batch.reset(mask)
    assert np.array_equal(batch.hashes(), moved)


def test_a_batch_renders_each_of_its_worlds(engine):
    world = make_pile(engine, 6)
    batch = engine.WorldBatch(world, 2)
    state = batch.state()
    state[1, :, 0] += 2.0
    batch.set_state(state)
    batch.step(10)
    focus = (at(engine, -2, -1, -2), at(engine, 6, 5, 2))
    first, second = (batch.render(index, 96, 64, focus=focus) for index in range(2))
    assert not np.array_equal(first, second)
    assert np.array_equal(second, batch.world(1).render(96, 64, focus=focus))
    with pytest.raises(rapier.InvalidValueError, match="index is 2"):
        batch.render(2)


def test_arrays_are_filled_in_place(engine):
    batch = engine.WorldBatch(make_pile(engine, 4), 2)
    out = np.empty((2, 4, engine.STATE), engine.dtype)
    for _ in range(3):
        batch.step()
        assert batch.state(out=out) is out
        assert np.array_equal(out, batch.state())


def test_forces_accelerate_by_the_formula(engine):
    world = engine.World(gravity=at(engine, 0, 0))
    body = world.add_body(shape=engine.Shape.ball(0.5), mass=2.0)
    batch = engine.WorldBatch(world, 3)
    forces = np.zeros((3, 1, engine.DIM + (1 if engine.DIM == 2 else 3)))
    forces[:, 0, 0] = [0.0, 4.0, 8.0]
    batch.set_forces(forces)
    batch.step(60)
    column = engine.DIM + (1 if engine.DIM == 2 else 4)
    assert batch.state()[:, 0, column] == pytest.approx([0.0, 2.0, 4.0], rel=1e-4)
    assert body.mass == pytest.approx(2.0, rel=1e-5)


def test_motors_reach_the_targets_of_their_worlds(engine):
    world = engine.World(gravity=at(engine, 0, 0))
    base = world.add_body("fixed")
    slide = world.add_body(shape=engine.Shape.ball(0.5), can_sleep=False)
    joint = world.add_joint("prismatic", base, slide, axis=at(engine, 1, 0), reduced=True)
    batch = engine.WorldBatch(world, 2)
    batch.set_motors([joint], [[0.5], [-1.0]], stiffness=100, damping=20)
    batch.step(240)
    assert batch.state()[:, 1, 0] == pytest.approx([0.5, -1.0], abs=1e-2)


def test_values_that_do_not_fit_change_nothing(engine):
    batch = engine.WorldBatch(make_pile(engine, 3), 2)
    before = batch.hashes()
    state = batch.state()
    state[1, 2, 0] = np.nan
    with pytest.raises(rapier.InvalidValueError, match=r"state\[1, 2\]"):
        batch.set_state(state)
    with pytest.raises(rapier.InvalidValueError, match="state has the shape"):
        batch.set_state(state[:, :2])
    with pytest.raises(rapier.InvalidValueError, match="mask has 3"):
        batch.reset([True] * 3)
    assert np.array_equal(batch.hashes(), before)


def test_a_state_of_unselected_worlds_is_ignored(engine):
    batch = engine.WorldBatch(make_pile(engine, 3), 2)
    before = batch.hashes()
    state = batch.state()
    state[0] = np.nan
    state[1, :, 0] += 1.0
    batch.set_state(state, mask=np.array([False, True]))
    hashes = batch.hashes()
    assert hashes[0] == before[0] and hashes[1] != before[1]
    assert np.array_equal(batch.state()[1], state[1])


@pytest.mark.parametrize("column", [0, -1])
def test_states_beyond_the_range_of_the_engine_are_refused(engine, column):
    batch = engine.WorldBatch(make_pile(engine, 3), 2)
    before = batch.hashes()
    state = batch.state()
    state[1, 2, column] = 1.0e16
    with pytest.raises(rapier.InvalidValueError, match=r"state\[1, 2\]"):
        batch.set_state(state)
    assert np.array_equal(batch.hashes(), before)


def make_slide(engine):
    """A world with a body on a slide, and the joint."""
    world = engine.World(gravity=at(engine, 0, 0))
    base = world.add_body("fixed")
    slide = world.add_body(shape=engine.Shape.ball(0.5), can_sleep=False)
    return world, world.add_joint("prismatic", base, slide, axis=at(engine, 1, 0))


def test_joints_of_other_worlds_change_no_motor(engine):
    world, joint = make_slide(engine)
    _, foreign = make_slide(engine)
    batch = engine.WorldBatch(world, 2)
    with pytest.raises(rapier.InvalidValueError, match="another world"):
        batch.set_motors([joint, foreign], np.ones((2, 2)), stiffness=100, damping=20)
    late = world.add_joint("prismatic", *world.bodies, axis=at(engine, 1, 0))
    with pytest.raises(rapier.StaleHandleError):
        batch.set_motors([joint, late], np.ones((2, 2)), stiffness=100, damping=20)
    batch.step(10)
    assert not batch.state()[:, :, : engine.DIM].any()


def test_too_many_worlds_are_a_memory_error(engine):
    with pytest.raises(MemoryError, match="worlds"):
        engine.WorldBatch(engine.World(), 2**60)


def test_worlds_with_different_parameters_form_a_batch(engine):
    worlds = []
    for gravity in (-1.0, -2.0, -4.0):
        world = engine.World(gravity=at(engine, 0, gravity))
        world.add_body(shape=engine.Shape.ball(0.5), can_sleep=False)
        worlds.append(world)
    batch = engine.WorldBatch.from_worlds(worlds)
    batch.step(30)
    for index, world in enumerate(worlds):
        world.step(30)
        assert batch.hashes()[index] == world.hash
    assert len(set(batch.hashes())) == 3
    batch.reset([False, True, False])
    assert batch.state()[1, 0, 1] == 0.0 and batch.state()[2, 0, 1] < 0.0
    worlds[1].add_body()
    with pytest.raises(rapier.InvalidValueError, match=r"worlds\[1\] has other bodies"):
        engine.WorldBatch.from_worlds(worlds)
    joint = worlds[0].add_joint("prismatic", worlds[0].add_body("fixed"), worlds[0].bodies[0], axis=at(engine, 1, 0))
    other = worlds[2].add_joint("fixed", worlds[2].add_body("fixed"), worlds[2].bodies[0])
    with pytest.raises(rapier.InvalidValueError, match=r"worlds\[1\] has other joints"):
        engine.WorldBatch.from_worlds([worlds[0], worlds[2]])
    other.remove()
    with pytest.raises(rapier.InvalidValueError, match=r"worlds\[1\] has other joints"):
        engine.WorldBatch.from_worlds([worlds[0], worlds[2]])
    joint.remove()
    with pytest.raises(rapier.InvalidValueError, match="worlds is empty"):
        engine.WorldBatch.from_worlds([])


@pytest.mark.parametrize("reduced", [True, False])
def test_the_coordinates_of_joints_are_those_of_the_bodies(engine, reduced):
    world = engine.World(gravity=at(engine, 0, 0))
    base = world.add_body("fixed")
    options = {"axis": [0, 0, 1]} if engine.DIM == 3 else {}
    slide, arm = (world.add_body(shape=engine.Shape.ball(0.5), can_sleep=False) for _ in range(2))
    joints = [
        world.add_joint("prismatic", base, slide, axis=at(engine, 1, 0), reduced=reduced, contacts=False),
        world.add_joint("revolute", slide, arm, reduced=reduced, contacts=False, **options),
    ]
    fixed = world.add_joint("fixed", world.add_body(), world.add_body())
    batch = engine.WorldBatch(world, 2)
    batch.set_motors(joints, [[0.5, 0.25], [-0.5, 1.0]], stiffness=100, damping=20)
    states = batch.joint_state(joints)
    assert states.shape == (2, 2, 2) and not states.any()
    batch.step(20)
    before = batch.joint_state(joints).copy()
    assert batch.joint_state(joints, out=states) is states
    batch.step()
    moved = (batch.joint_state(joints)[:, :, 0] - before[:, :, 0]) * 60
    assert moved == pytest.approx(batch.joint_state(joints)[:, :, 1], rel=0.1, abs=0.02)
    batch.step(240)
    assert batch.joint_state(joints)[:, :, 0] == pytest.approx(np.array([[0.5, 0.25], [-0.5, 1.0]]), abs=2e-2)
    joints[0].set_motor_position(0.5, 100, 20)
    world.step(240)
    assert joints[0].position == pytest.approx(0.5, abs=2e-2) and abs(joints[0].velocity) < 1e-2
    with pytest.raises(rapier.InvalidValueError, match="only revolute and prismatic"):
        batch.joint_state([fixed])
