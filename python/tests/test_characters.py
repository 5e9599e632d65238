"""Characters: they walk, climb, ride and push."""

import numpy as np
import pytest
from conftest import at, make_ground

import rapier


def make_walker(engine, world, x=0.0, y=1.0):
    """A capsule of the height 2 m with its feet at y - 1."""
    return world.add_body("kinematic_position", engine.Shape.capsule(0.6, 0.4), position=at(engine, x, y))


def walk(engine, world, controller, walker, speed, steps, **options):
    """Walks along x, with a downward part. Returns the last movement."""
    for _ in range(steps):
        movement = controller.move(walker, at(engine, speed * world.dt, -5.0 * world.dt), **options)
        world.step()
    return movement


def test_a_character_walks_at_its_speed(engine):
    world = make_ground(engine)
    walker = make_walker(engine, world)
    world.step()
    movement = walk(engine, world, engine.CharacterController(), walker, 2.0, 60)
    assert walker.position == pytest.approx(at(engine, 2.0, 1.02), abs=0.01)
    assert movement.grounded and not movement.sliding
    assert movement.ground == world.colliders[0]
    assert movement.ground_normal == pytest.approx(at(engine, 0, 1), abs=1e-3)


def test_a_wall_stops_it_and_is_reported(engine):
    world = make_ground(engine)
    wall = world.add_collider(engine.Shape.box(at(engine, 0.5, 2, 5)), position=at(engine, 2, 2))
    walker = make_walker(engine, world)
    world.step()
    movement = walk(engine, world, engine.CharacterController(offset=0.02), walker, 2.0, 60)
    assert walker.position[0] == pytest.approx(2 - 0.5 - 0.4 - 0.02, abs=0.01)
    assert wall in movement.collisions


@pytest.mark.parametrize("height, climbs", [(0.4, True), (0.2, False)])
def test_steps_up_to_the_height_are_climbed(engine, height, climbs):
    world = make_ground(engine)
    world.add_collider(engine.Shape.box(at(engine, 2, 0.15, 5)), position=at(engine, 3, 0.15))
    walker = make_walker(engine, world)
    world.step()
    walk(engine, world, engine.CharacterController(step_height=height, step_width=0.1), walker, 2.0, 90)
    assert (walker.position[1] > 1.25) == climbs


def test_a_lift_carries_the_character(engine):
    world = engine.World()
    lift = world.add_body("kinematic_velocity", engine.Shape.box(at(engine, 2, 0.5, 2)), position=at(engine, 0, -0.5), linvel=at(engine, 0, 1))
    walker = make_walker(engine, world, y=1.02)
    world.step()
    walk(engine, world, engine.CharacterController(), walker, 0.0, 60)
    assert walker.position[1] - lift.position[1] == pytest.approx(1.52, abs=0.05)


def test_a_mass_pushes_bodies(engine):
    pushed = []
    for mass in (None, 80.0):
        world = make_ground(engine)
        crate = world.add_body(shape=engine.Shape.box(at(engine, 0.4, 0.4, 0.4)), position=at(engine, 1.5, 0.4))
        walker = make_walker(engine, world)
        world.step()
        walk(engine, world, engine.CharacterController(), walker, 2.0, 60, mass=mass)
        pushed.append(crate.position[0])
    assert pushed[0] == pytest.approx(1.5, abs=0.05) and pushed[1] > 1.8


def test_a_moved_character_begins_at_its_new_pose(engine):
    world = make_ground(engine)
    wall = world.add_collider(engine.Shape.box(at(engine, 0.5, 2, 5)), position=at(engine, 12, 2))
    walker = make_walker(engine, world)
    controller = engine.CharacterController(offset=0.02)
    world.step()
    walker.position = at(engine, 10, 1.02)
    movement = controller.move(walker, at(engine, 3, 0))
    assert movement.translation[0] == pytest.approx(12 - 0.5 - 0.4 - 0.02 - 10, abs=0.01)
    assert movement.collisions == [wall]
    world.step()
    assert walker.position[0] == pytest.approx(11.08, abs=0.01)


def test_obstacles_are_those_of_the_moment(engine):
    world = make_ground(engine)
    wall = world.add_body("fixed", engine.Shape.box(at(engine, 0.5, 2, 5)), position=at(engine, 2, 2))
    walker = make_walker(engine, world, y=1.02)
    controller = engine.CharacterController(offset=0.02)

    def way():
        return controller.move(walker, at(engine, 3, 0)).translation[0]

    assert way() == pytest.approx(1.08, abs=0.01)  # before the first step
    world.step()
    walker.position = at(engine, 0, 1.02)
    wall.position = at(engine, 50, 2)
    assert way() == pytest.approx(3.0, abs=0.01)
    late = world.add_collider(engine.Shape.box(at(engine, 0.5, 2, 5)), position=at(engine, 3, 2))
    assert way() == pytest.approx(2.08, abs=0.01)
    late.remove()
    assert way() == pytest.approx(3.0, abs=0.01)
    wall.position = at(engine, 2.5, 2)
    assert way() == pytest.approx(1.58, abs=0.01)
    wall.remove()
    assert way() == pytest.approx(3.0, abs=0.01)


def test_invalid_characters_are_refused(engine):
    world = make_ground(engine)
    controller = engine.CharacterController()
    ball = world.add_body(shape=engine.Shape.ball(0.5))
    with pytest.raises(rapier.InvalidValueError, match="kinematic_position"):
        controller.move(ball, at(engine, 0, 0))
    with pytest.raises(rapier.InvalidValueError, match="must have a collider"):
        controller.move(world.add_body("kinematic_position"), at(engine, 0, 0))
    with pytest.raises(rapier.InvalidValueError, match="mass is 0"):
        controller.move(make_walker(engine, world), at(engine, 0, 0), mass=0.0)
    with pytest.raises(rapier.InvalidValueError, match="offset is -1"):
        engine.CharacterController(offset=-1.0)
    with pytest.raises(rapier.InvalidValueError, match="up is"):
        engine.CharacterController(up=np.zeros(engine.DIM))
    with pytest.raises(TypeError, match="heigth"):
        engine.CharacterController(heigth=1.0)
