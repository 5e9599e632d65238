"""Mistakes: an exception that names the value, and a world that lives on."""

import numpy as np
import pytest
from conftest import at, make_ground

import rapier


@pytest.mark.parametrize("options, named", [
    ({"position": [0.0] * 7}, "position"),
    ({"linvel": "fast"}, "linvel is fast"),
    ({"density": -1.0}, "density is -1"),
    ({"friction": float("nan")}, "friction is NaN"),
    ({"gravity_scale": float("inf")}, "gravity_scale is inf"),
])
def test_values_are_named(engine, options, named):
    world = make_ground(engine)
    with pytest.raises(rapier.InvalidValueError, match=named):
        world.add_body(shape=engine.Shape.ball(0.5), **options)
    assert len(world) == 0
    world.step()


def test_not_a_number_is_refused_in_vectors(engine):
    world = engine.World()
    body = world.add_body()
    for name in ["position", "linvel"]:
        with pytest.raises(rapier.InvalidValueError, match=f"{name} is NaN"):
            setattr(body, name, at(engine, np.nan, 0))
    assert np.array_equal(body.position, at(engine, 0, 0))


def test_unknown_arguments_are_named(engine):
    world = engine.World()
    with pytest.raises(TypeError, match="add_body.*colour"):
        world.add_body(colour="red")
    with pytest.raises(TypeError, match="ccd=maybe"):
        world.add_body(ccd="maybe")
    with pytest.raises(TypeError, match="add_body.*density"):
        world.add_body(density=1.0)


def test_removed_objects_say_so(engine):
    world = engine.World()
    body = world.add_body(shape=engine.Shape.ball(0.5))
    (collider,) = body.colliders
    body.remove()
    assert not body.alive
    for use in [lambda: body.position, body.remove, lambda: collider.friction, lambda: world.add_collider(engine.Shape.ball(1), body)]:
        with pytest.raises(rapier.StaleHandleError):
            use()
    assert "removed" in repr(body)
    new = world.add_body()
    assert new != body and not body.alive


def test_objects_of_other_worlds_are_refused(engine):
    world, other = engine.World(), engine.World()
    body, foreign = world.add_body(), other.add_body()
    with pytest.raises(rapier.InvalidValueError, match="another world"):
        world.add_collider(engine.Shape.ball(1), foreign)
    with pytest.raises(rapier.InvalidValueError, match="another world"):
        world.add_joint("fixed", body, foreign)


@pytest.mark.parametrize("make, named", [
    (lambda engine: engine.Shape.ball(-1), "radius"),
    (lambda engine: engine.Shape.ball(float("nan")), "radius is NaN"),
    (lambda engine: engine.Shape.box([1.0]), "half_extents"),
    (lambda engine: engine.Shape.halfspace(at(engine, 0, 0)), "normal"),
    (lambda engine: engine.Shape.convex_hull(np.zeros((3, 5))), r"vertices has the shape \[3, 5\]"),
])
def test_shapes_that_cannot_be_are_refused(engine, make, named):
    with pytest.raises(rapier.InvalidValueError, match=named):
        make(engine)


def test_a_mesh_with_an_index_out_of_range_is_refused():
    with pytest.raises(rapier.InvalidValueError, match="9"):
        rapier.dim3.Shape.mesh(np.eye(3), [[0, 1, 9]])


def test_kinds_are_named(engine):
    world = engine.World()
    body, other = world.add_body(), world.add_body()
    with pytest.raises(rapier.InvalidValueError, match="elastic"):
        world.add_body("elastic")
    with pytest.raises(rapier.InvalidValueError, match="glue"):
        world.add_joint("glue", body, other)
    with pytest.raises(rapier.InvalidValueError, match="needs a length"):
        world.add_joint("rope", body, other)
    joint = world.add_joint("fixed", body, other)
    with pytest.raises(rapier.InvalidValueError, match="motors"):
        joint.set_motor_velocity(1.0, 1.0)


def test_arrays_that_do_not_fit_are_refused(engine):
    world = engine.World()
    world.add_body()
    with pytest.raises(rapier.InvalidValueError, match="out has the shape"):
        world.state(out=np.zeros((2, engine.STATE), engine.dtype))
    with pytest.raises(rapier.InvalidValueError, match="out is"):
        world.state(out=np.zeros((1, engine.STATE), np.int32))


def test_every_exception_has_one_base(engine):
    assert issubclass(rapier.InvalidValueError, (rapier.RapierError)) and issubclass(rapier.InvalidValueError, ValueError)
    for error in [rapier.InvalidValueError, rapier.StaleHandleError, rapier.SnapshotError]:
        assert issubclass(error, rapier.RapierError) and error.__module__ == "rapier"
    with pytest.raises(rapier.RapierError, match="radius"):
        engine.Shape.ball(-1)


def test_values_beyond_the_range_of_the_engine_are_refused(engine):
    world = engine.World()
    body = world.add_body(shape=engine.Shape.ball(0.5))
    before = world.hash
    huge = at(engine, 1.0e16, 0)
    angular = 1.0e16 if engine.DIM == 2 else [0.9e15, 0.9e15, 0.0]
    for owner, name, value in [
        (body, "position", huge), (body, "linvel", huge), (body, "angvel", angular), (world, "gravity", huge),
        (body.colliders[0], "friction", 1.0e16), (body.colliders[0], "restitution", 1.0e16), (body.colliders[0], "restitution", -1.0),
    ]:
        with pytest.raises(rapier.InvalidValueError, match=f"{name} is"):
            setattr(owner, name, value)
    with pytest.raises(rapier.InvalidValueError, match="point is"):
        body.apply_impulse(at(engine, 1, 0), point=huge)
    assert world.hash == before


@pytest.mark.parametrize("kind", ["dynamic", "fixed", "kinematic_velocity"])
def test_only_bodies_of_one_kind_move_to_a_pose(engine, kind):
    body = engine.World().add_body(kind)
    with pytest.raises(rapier.InvalidValueError, match=f"{kind}.*kinematic_position"):
        body.move_to(at(engine, 1, 0))


def test_directions_whose_length_overflows_are_refused(engine):
    huge = 1.0e25 if engine.dtype == np.float32 else 1.0e200
    with pytest.raises(rapier.InvalidValueError, match="normal is"):
        engine.Shape.halfspace(at(engine, huge, 0))
    world = engine.World()
    body, other = world.add_body(), world.add_body()
    with pytest.raises(rapier.InvalidValueError, match="axis is"):
        world.add_joint("prismatic", body, other, axis=at(engine, huge, 0))
    if engine.DIM == 3:
        with pytest.raises(rapier.InvalidValueError, match="axis is"):
            world.add_joint("revolute", body, other, axis=[huge, 0, 0])
        with pytest.raises(rapier.InvalidValueError, match="rotation is"):
            body.rotation = [huge, 0, 0, huge]
        with pytest.raises(rapier.InvalidValueError, match="rotation is"):
            world.add_body(rotation=[huge, 0, 0, huge])
    assert body.rotation == pytest.approx(0.0 if engine.DIM == 2 else [0, 0, 0, 1])


def test_a_joint_with_a_removed_body_is_refused(engine):
    world = engine.World()
    body, removed = world.add_body(), world.add_body()
    removed.remove()
    with pytest.raises(rapier.StaleHandleError):
        world.add_joint("fixed", body, removed)
