"""Gears, racks and pulleys: accelerations against formulas."""

import pickle

import numpy as np
import pytest
from conftest import at

import rapier


def inertia(engine, mass):
    """The moment of inertia of a ball of radius 0.5 (3D), or of a disc (2D)."""
    return (0.5 if engine.DIM == 2 else 0.4) * mass * 0.25


def add_ball(engine, world, x, y, mass):
    """A ball of a mass."""
    return world.add_body(shape=engine.Shape.ball(0.5), mass=mass, position=at(engine, x, y), can_sleep=False)


def add_wheel(engine, world, x, mass):
    """A wheel about z on an axle of the world."""
    wheel = add_ball(engine, world, x, 0, mass)
    world.add_joint("revolute", world.add_body("fixed", position=at(engine, x, 0)), wheel, **about_z(engine, "axis"))
    return wheel


def about_z(engine, *names):
    return {name: [0, 0, 1] for name in names} if engine.DIM == 3 else {}


def spin(engine, body):
    return body.angvel if engine.DIM == 2 else body.angvel[2]


def set_spin(engine, body, value):
    body.angvel = value if engine.DIM == 2 else [0, 0, value]


def turn(engine, body, torque):
    body.add_torque(torque if engine.DIM == 2 else [0, 0, torque])


@pytest.mark.parametrize("ratio, mass", [(-3.0, 1.0), (0.5, 2.0), (1.0, 1000.0), (10.0, 0.1)])
def test_gears_share_a_torque_by_their_ratio(engine, ratio, mass):
    # A torque τ on the first wheel: α₁ = τ / (I₁ + I₂ / r²), α₂ = -α₁ / r.
    world = engine.World(gravity=at(engine, 0, 0))
    first, second = add_wheel(engine, world, 0, 1.0), add_wheel(engine, world, 2, mass)
    world.add_joint("gear", first, second, ratio=ratio, **about_z(engine, "axis1", "axis2"))
    torque = 5.0 * (inertia(engine, 1.0) + inertia(engine, mass) / ratio**2)
    turn(engine, first, torque)
    world.step(60)
    assert spin(engine, first) == pytest.approx(5.0, rel=2e-3)
    assert spin(engine, second) == pytest.approx(-5.0 / ratio, rel=2e-3)
    assert pickle.loads(pickle.dumps(world)).hash == world.hash


def test_a_gear_has_backlash(engine):
    world = engine.World(gravity=at(engine, 0, 0))
    first, second = add_wheel(engine, world, 0, 1.0), add_wheel(engine, world, 2, 1.0)
    world.add_joint("gear", first, second, backlash=0.5, **about_z(engine, "axis1", "axis2"))
    set_spin(engine, first, 0.5)
    # Half of the backlash is on each side.
    world.step(27)
    assert spin(engine, second) == 0.0
    world.step(60)
    assert spin(engine, first) == pytest.approx(0.25, abs=0.01)
    assert spin(engine, second) == pytest.approx(-0.25, abs=0.01)


@pytest.mark.parametrize("radius, mass", [(-0.25, 1.0), (0.125, 100.0), (2.0, 0.1)])
def test_a_pinion_moves_its_rack(engine, radius, mass):
    # A torque τ on a pinion of radius r moves a rack of mass m: a = r τ / (I + m r²).
    world = engine.World(gravity=at(engine, 0, 0))
    pinion, bar = add_wheel(engine, world, 0, 1.0), add_ball(engine, world, 0, 0.8, mass)
    world.add_joint("prismatic", world.add_body("fixed", position=at(engine, 0, 0.8)), bar, axis=at(engine, 1, 0))
    # The two bodies overlap: without contacts, they move freely.
    world.add_joint("rack", pinion, bar, axis2=at(engine, 1, 0), radius=radius, **about_z(engine, "axis1"))
    torque = 5.0 * (inertia(engine, 1.0) + mass * radius**2)
    turn(engine, pinion, torque)
    world.step(60)
    assert bar.linvel[0] == pytest.approx(5.0 * radius, rel=2e-3)
    assert spin(engine, pinion) == pytest.approx(5.0, rel=2e-3)


@pytest.mark.parametrize("ratio, mass", [(1.0, 3.0), (2.0, 1.0), (0.5, 2.0)])
def test_weights_on_a_pulley_accelerate(engine, ratio, mass):
    # a₁ = g (m₁ - m₂ / r) / (m₁ + m₂ / r²)
    world = engine.World(gravity=at(engine, 0, -10))
    first, second = add_ball(engine, world, -1, 20, 1.0), add_ball(engine, world, 1, 20, mass)
    over = {"over1": at(engine, -1, 40), "over2": at(engine, 1, 40)}
    world.add_joint("pulley", first, second, anchor1=at(engine, 0, 0.5), anchor2=at(engine, 0, 0.5), length=19.5 * (1 + ratio), ratio=ratio, **over)
    world.step(30)
    acceleration = 10 * (1 - mass / ratio) / (1 + mass / ratio**2)
    assert first.linvel[1] == pytest.approx(-0.5 * acceleration, abs=0.02)
    assert second.linvel[1] == pytest.approx(0.5 * acceleration / ratio, abs=0.02)


def test_unusable_transmissions_are_refused_by_name(engine):
    world = engine.World()
    first, second = world.add_body(), world.add_body()
    over = {"over1": at(engine, 0, 5), "over2": at(engine, 1, 5)}
    for kind, options, text in [
        ("gear", {"ratio": 0.0}, "ratio is 0"), ("gear", {"ratio": np.nan}, "ratio is"), ("gear", {"backlash": -1.0}, "backlash is -1"),
        ("rack", {}, "needs a radius"), ("rack", {"radius": 0.0}, "radius is 0"), ("rack", {"radius": 1.0, "axis2": at(engine, 0, 0)}, "axis"),
        ("pulley", {"length": 1.0}, "needs over1"), ("pulley", over, "needs a length"), ("pulley", {**over, "length": -1.0}, "length is -1"),
        ("pulley", {**over, "length": 1.0, "ratio": np.inf}, "ratio is"), ("pulley", {**over, "length": 1.0, "over2": at(engine, np.nan, 0)}, "over2"),
        ("gear", {"limits": (0.0, 1.0)}, "no limits"), ("gear", {"axis": at(engine, 1, 0)}, "no axis"), ("gear", {"reduced": True}, "multibody"),
    ]:
        with pytest.raises(rapier.InvalidValueError, match=text):
            world.add_joint(kind, first, second, **options)
    if engine.DIM == 2:
        for kind, options in [("gear", {"axis1": [1, 0]}), ("rack", {"radius": 1.0, "axis1": [1, 0]})]:
            with pytest.raises(rapier.InvalidValueError, match="2D"):
                world.add_joint(kind, first, second, **options)
    with pytest.raises(TypeError, match="axis1"):
        world.add_joint("fixed", first, second, axis1=at(engine, 1, 0))
