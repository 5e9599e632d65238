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
