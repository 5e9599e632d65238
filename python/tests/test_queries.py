"""Queries against geometry."""

import numpy as np
import pytest
from conftest import at, make_pile, turned

import rapier


def test_a_ray_hits_a_ball_where_the_formula_says(engine):
    world = engine.World()
    ball = world.add_body(shape=engine.Shape.ball(1.0), position=at(engine, 5, 0))
    hit = world.cast_ray(at(engine, 0, 0.6), at(engine, 2, 0))
    assert hit.collider.body == ball
    assert hit.toi == pytest.approx((5 - 0.8) / 2, rel=1e-5)
    assert hit.point == pytest.approx(at(engine, 4.2, 0.6), rel=1e-5)
    assert hit.normal == pytest.approx(at(engine, -0.8, 0.6), abs=1e-5)
    assert world.cast_ray(at(engine, 0, 0.6), at(engine, 2, 0), max_toi=2.0) is None
    assert world.cast_ray(at(engine, 0, 1.1), at(engine, 1, 0)) is None


def test_many_rays_answer_as_single_ones(engine):
    world = engine.World()
    for x in range(5):
        world.add_body(shape=engine.Shape.ball(0.4), position=at(engine, x, x * 0.3))
    origins = np.array([at(engine, x, 5) for x in np.linspace(-1, 5, 50)])
    directions = np.tile(at(engine, 0, -1), (50, 1))
    times, normals = world.cast_rays(origins, directions)
    assert np.isinf(times).any() and np.isfinite(times).any()
    for origin, direction, time, normal in zip(origins, directions, times, normals):
        hit = world.cast_ray(origin, direction)
        assert (hit.toi if hit else np.inf) == time
        assert np.array_equal(hit.normal if hit else at(engine, 0, 0), normal)


def test_queries_see_changes_without_a_step(engine):
    world = engine.World()
    body = world.add_body(shape=engine.Shape.ball(1.0), position=at(engine, 5, 0))
    assert world.cast_ray(at(engine, 0, 0), at(engine, 1, 0)).toi == pytest.approx(4)
    body.remove()
    assert world.cast_ray(at(engine, 0, 0), at(engine, 1, 0)) is None


def test_the_nearest_point_of_a_box_is_on_its_face(engine):
    world = engine.World()
    box = world.add_collider(engine.Shape.box(at(engine, 1, 1, 1)))
    found = world.project_point(at(engine, 3, 0.5))
    assert found.collider == box and not found.inside
    assert found.point == pytest.approx(at(engine, 1, 0.5), abs=1e-6)
    assert world.project_point(at(engine, 0, 0)).inside


def test_overlaps_are_those_of_the_shape_at_the_pose(engine):
    world = engine.World()
    near = world.add_collider(engine.Shape.ball(1.0))
    world.add_collider(engine.Shape.ball(1.0), position=at(engine, 5, 0))
    assert world.overlaps(engine.Shape.box(at(engine, 0.5, 0.5, 0.5)), position=at(engine, 1.2, 0)) == [near]


def test_queries_leave_the_world_unchanged(engine):
    world, twin = engine.World(), engine.World()
    for each in [world, twin]:
        each.add_body(shape=engine.Shape.ball(1.0), position=at(engine, 5, 0))
        each.step()
        each.bodies[0].position = at(engine, 7, 0)
    world.cast_ray(at(engine, 0, 0), at(engine, 1, 0))
    assert world.hash == twin.hash
    world.step()
    twin.step()
    assert world.hash == twin.hash


def test_queries_of_moved_bodies_leave_the_steps_unchanged(engine):
    world, twin = make_pile(engine), make_pile(engine)
    for _ in range(20):
        for each in [world, twin]:
            each.step(5)
            for body in each.bodies[::3]:
                body.position = body.position + at(engine, 0.25, 0.125)
        assert world.overlaps(engine.Shape.ball(100.0))
        world.step(5)
        twin.step(5)
        assert world.hash == twin.hash


def test_queries_find_moved_bodies_without_a_step(engine):
    world = engine.World()
    body = world.add_body(shape=engine.Shape.ball(1.0), position=at(engine, 5, 0))
    part = world.add_collider(engine.Shape.ball(0.5), body, position=at(engine, 0, 3))
    world.step()
    body.position, body.rotation = at(engine, 8, 0), turned(engine, np.pi / 2)
    origin, direction = at(engine, 0, 0), at(engine, 1, 0)
    # The part is now in front of the ball.
    hit = world.cast_ray(origin, direction)
    assert hit.collider == part and hit.toi == pytest.approx(4.5, abs=1e-4)
    assert part.position == pytest.approx(at(engine, 5, 0), abs=1e-4)
    assert world.cast_rays([origin], [direction])[0] == pytest.approx([4.5], abs=1e-4)
    assert world.project_point(at(engine, 8, 4)).point == pytest.approx(at(engine, 8, 1), abs=1e-4)
    assert world.overlaps(engine.Shape.ball(0.25), position=at(engine, 8, 0)) == [body.colliders[0]]


def test_queries_find_moved_bodies_after_the_step(engine):
    world = engine.World(gravity=at(engine, 0, 0))
    body = world.add_body(shape=engine.Shape.ball(1.0), position=at(engine, 5, 0))
    other = world.add_body(shape=engine.Shape.ball(1.0), position=at(engine, 20, 0))

    def toi():
        return world.cast_ray(at(engine, 0, 0), at(engine, 1, 0)).toi

    world.step()
    assert toi() == pytest.approx(4)
    body.position = at(engine, 7, 0)
    world.step()
    assert toi() == pytest.approx(6)
    body.enabled = False
    world.step()
    assert toi() == pytest.approx(19)
    other.linvel = at(engine, 60, 0)
    world.step(2)
    assert toi() == pytest.approx(21)


def test_rays_that_are_not_a_number_are_refused(engine):
    world = engine.World()
    fine, bad = np.zeros((2, engine.DIM)), np.full((2, engine.DIM), np.nan)
    for rays, named in [((bad, fine), "origins"), ((fine, bad), "directions")]:
        with pytest.raises(rapier.InvalidValueError, match=f"{named} has the element NaN"):
            world.cast_rays(*rays)
