"""Fixtures: every test with `engine` runs with all four modules."""

import numpy as np
import pytest

import rapier


@pytest.fixture(params=["dim2", "dim3", "dim2_f64", "dim3_f64"])
def engine(request):
    """A module of the package."""
    return getattr(rapier, request.param)


def at(engine, x, y, z=0.0):
    """A point. Two dimensions leave out z."""
    return np.array([x, y, z][: engine.DIM])


def turned(engine, angle):
    """A rotation about z."""
    return angle if engine.DIM == 2 else [0.0, 0.0, np.sin(angle / 2), np.cos(angle / 2)]


def make_ground(engine, **options):
    """A world with a ground whose surface is at y = 0."""
    world = engine.World(**options)
    world.add_collider(engine.Shape.halfspace(at(engine, 0, 1)))
    return world


def make_pile(engine, count=30):
    """A pile that falls on a ground."""
    world = make_ground(engine)
    for number in range(count):
        place = at(engine, number % 3 * 1.25 + number * 0.03125, 1 + number // 3, number % 2 * 0.5)
        shape = engine.Shape.box(at(engine, 0.5, 0.25, 0.375)) if number % 2 else engine.Shape.ball(0.375)
        world.add_body(shape=shape, position=place)
    return world
