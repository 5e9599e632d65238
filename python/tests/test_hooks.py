"""Hooks: callables filter pairs and change contacts."""

import gc
import weakref

import numpy as np
import pytest
from conftest import at, make_ground

import rapier


def make_drop(engine, **options):
    """A ball with hooks that falls on a ground."""
    world = make_ground(engine)
    ball = world.add_body(shape=engine.Shape.ball(0.5), position=at(engine, 0, 1), hooks=True, **options)
    return world, ball


@pytest.mark.parametrize("allowed", [True, False])
def test_a_filter_decides_about_contacts(engine, allowed):
    world, ball = make_drop(engine)
    pairs = []

    def decide(pair):
        pairs.append((pair.collider1, pair.collider2, pair.body1, pair.body2, pair.position1, pair.position2, pair.linvel1, pair.linvel2))
        return allowed

    world.set_hooks(filter_contact=decide)
    world.step(60)
    assert (ball.position[1] < 0) == (not allowed)
    assert {*pairs[0][:2]} == {world.colliders[0], ball.colliders[0]}
    assert {*pairs[0][2:4]} == {None, ball}
    position = next(position for position in pairs[0][4:6] if position is not None)
    assert position.shape == (engine.DIM,) and 0.4 < position[1] <= 1.0
    velocity = next(velocity for velocity in pairs[0][6:8] if velocity is not None)
    assert velocity[1] <= 0.0


def test_a_filter_decides_about_intersections(engine):
    for allowed in (True, False):
        world = engine.World(gravity=at(engine, 0, 0))
        world.add_collider(engine.Shape.ball(1.0), sensor=True, events=True, hooks=True)
        world.add_body(shape=engine.Shape.ball(0.5))
        world.set_hooks(filter_intersection=lambda pair: allowed)
        world.step()
        assert len(world.collision_events()) == allowed


def test_contacts_without_hooks_call_nothing(engine):
    world = make_ground(engine)
    world.add_body(shape=engine.Shape.ball(0.5), position=at(engine, 0, 0.5))
    world.set_hooks(filter_contact=lambda pair: 1 / 0, modify_contact=lambda contact: 1 / 0)
    world.step(10)


def test_friction_and_belts_change(engine):
    def ice(contact):
        contact.friction = 0.0

    def belt(contact):
        velocity = at(engine, 2.0, 0.0)
        contact.tangent_velocity = velocity if contact.body1 is None else -velocity

    speeds = []
    for change in (None, ice, belt):
        world = make_ground(engine)
        box = world.add_body(shape=engine.Shape.box(at(engine, 0.5, 0.5, 0.5)), position=at(engine, 0, 0.5), linvel=at(engine, 1, 0), hooks=True)
        world.set_hooks(modify_contact=change)
        world.step(90)
        speeds.append(box.linvel[0])
    assert speeds == pytest.approx([0.0, 1.0, 2.0], abs=0.02)


def test_a_contact_has_points_and_a_normal(engine):
    world, _ = make_drop(engine)
    seen = []
    world.set_hooks(modify_contact=lambda contact: seen.append((contact.normal, contact.points, contact.friction, contact.restitution, contact.solid)))
    world.step(60)
    normal, points, friction, restitution, solid = seen[-1]
    assert np.abs(normal) == pytest.approx(at(engine, 0, 1), abs=1e-3)
    assert points.shape == (1, engine.DIM) and points[0] == pytest.approx(at(engine, 0, 0), abs=1e-2)
    assert friction == pytest.approx(0.5) and restitution == 0.0 and solid


def test_bodies_pass_contacts_that_are_not_solid(engine):
    world, ball = make_drop(engine, events=True)

    def pass_through(contact):
        contact.solid = False

    world.set_hooks(modify_contact=pass_through)
    world.step(60)
    assert ball.position[1] < -1
    assert world.collision_events()[0].started


def test_a_platform_holds_from_above(engine):
    heights = []
    for speed in (0.0, 9.0):
        world = engine.World()
        world.add_collider(engine.Shape.box(at(engine, 3, 0.1, 3)), hooks=True)
        ball = world.add_body(shape=engine.Shape.ball(0.3), position=at(engine, 0, 1 if speed == 0 else -1.5), linvel=at(engine, 0, speed), can_sleep=False)

        def platform(contact):
            contact.one_way(at(engine, 0, 1 if contact.body1 is None else -1), 0.3)

        world.set_hooks(modify_contact=platform)
        world.step(180)
        heights.append(ball.position[1])
    assert heights == pytest.approx([0.4, 0.4], abs=0.02)


def test_an_exception_of_a_hook_reaches_the_caller(engine):
    world, ball = make_drop(engine)
    calls = []

    def fail(pair):
        calls.append(pair)
        raise KeyError("hook")

    world.set_hooks(filter_contact=fail)
    with pytest.raises(KeyError, match="hook"):
        world.step(60)
    assert len(calls) == 1
    world.set_hooks()
    world.step(60)
    assert ball.position[1] == pytest.approx(0.5, abs=0.01)


def test_a_hook_that_uses_its_world_raises_instead_of_waiting(engine):
    world, ball = make_drop(engine)
    uses = [lambda: ball.position, lambda: world.step(), lambda: world.hash, lambda: world.snapshot(), lambda: world.bodies]
    for use in uses:
        world.set_hooks(filter_contact=lambda pair: use())
        with pytest.raises(RuntimeError, match="hook"):
            world.step(60)
    assert ball.position[1] > -2


class Filter:
    """A callable that refers to its world by an object."""

    def __init__(self, referred):
        self.referred = referred

    def __call__(self, pair):
        return True


class Collector(Filter):
    """Keeps its arguments."""

    def __call__(self, argument):
        self.referred.append(argument)
        return True


@pytest.mark.parametrize("refer", [
    lambda world: world, lambda world: world.bodies, lambda world: world.colliders, lambda world: world.collision_events(),
    lambda world: world.cast_ray(-world.gravity, world.gravity), lambda world: world.project_point(-world.gravity), lambda world: world.add_joint("fixed", *world.bodies),
], ids=["world", "bodies", "colliders", "events", "hit", "projection", "joint"])
def test_a_world_whose_hooks_refer_to_it_is_freed(engine, refer):
    world, _ = make_drop(engine, events=True)
    world.add_body()
    world.step(60)
    referred = refer(world)
    assert referred
    hook = Filter(referred)
    freed = weakref.ref(hook)
    world.set_hooks(filter_contact=hook)
    del world, referred, hook, _
    gc.collect()
    assert freed() is None


def test_a_batch_in_a_hook_of_its_original_is_freed(engine):
    world, _ = make_drop(engine)
    hook = Filter(engine.WorldBatch(world, 2))
    freed = weakref.ref(hook)
    world.set_hooks(filter_contact=hook)
    del world, hook, _
    gc.collect()
    assert freed() is None


def test_pairs_and_contacts_in_a_hook_are_freed(engine):
    world, _ = make_drop(engine)
    hook = Collector([])
    world.set_hooks(filter_contact=hook, modify_contact=hook)
    world.step(60)
    assert len({type(part) for part in hook.referred}) == 2
    freed = weakref.ref(hook)
    del world, hook, _
    gc.collect()
    assert freed() is None


def test_invalid_changes_raise_in_the_hook(engine):
    world, _ = make_drop(engine)

    def change(contact):
        contact.friction = -1.0

    world.set_hooks(modify_contact=change)
    with pytest.raises(rapier.InvalidValueError, match="friction is -1"):
        world.step(60)
