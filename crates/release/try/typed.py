"""A typed program of a user, for `mypy --strict`. Lines with a mark are mistakes that the checker must find."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Optional, Union

import numpy as np
from numpy.typing import NDArray

import rapier
from rapier import dim2, dim3, dim3_f64


def drop(height: float) -> tuple[dim3.World, dim3.Body]:
    world = dim3.World(gravity=[0, -9.81, 0])
    world.add_collider(dim3.Shape.halfspace([0, 1, 0]), friction=0.8)
    ball = world.add_body("dynamic", dim3.Shape.ball(0.5), position=(0, height, 0), events=True)
    return world, ball


def first_hit(world: dim3.World) -> Optional[dim3.Collider]:
    hit: Optional[dim3.RayHit] = world.cast_ray([0, 5, 0], np.array([0.0, -1.0, 0.0]), 10.0)
    return None if hit is None else hit.collider


def belt(contact: dim3.Contact) -> None:
    contact.tangent_velocity = [1, 0, 0]


def drives() -> int:
    world = dim3_f64.World()
    car: dim3_f64.Vehicle = world.add_vehicle(world.add_body(shape=dim3_f64.Shape.box([2, 0.3, 0.9])))
    return car.add_wheel([1, -0.2, 0], rest_length=0.4, radius=0.3)


def angles(count: int) -> NDArray[np.float64]:
    world = dim2.World()
    base, arm = world.add_body("fixed"), world.add_body(shape=dim2.Shape.box([0.5, 0.1]))
    joint: dim2.Joint = world.add_joint("revolute", base, arm, anchor2=[-0.5, 0], reduced=True)
    batch = dim2.WorldBatch(world, count)
    batch.set_motors([joint], np.zeros((count, 1)), stiffness=20, damping=2)
    batch.step(10)
    return batch.joint_state([joint])[:, 0, 0].astype(np.float64)


def height(world: dim3.World, ball: dim3.Body) -> float:
    return float(ball.position[1])


def mistakes(world: dim3.World) -> list[Union[str, type[Exception]]]:
    """What the engine refuses, although the marked lines hide it from the checker."""
    found: list[Union[str, type[Exception]]] = []
    try:
        world.add_body("hovering")  # type: ignore[arg-type]
    except ValueError as error:
        found.append(type(error))
    try:
        world.add_collider("ball")  # type: ignore[arg-type]
    except TypeError as error:
        found.append(type(error))
    try:
        dim2.World().add_vehicle  # type: ignore[attr-defined]
    except AttributeError as error:
        found.append(type(error))
    return found


def main() -> None:
    world, ball = drop(3.0)
    world.set_hooks(modify_contact=belt)
    world.step(300)
    event: dim3.CollisionEvent
    for event in world.collision_events():
        assert event.started
    assert abs(height(world, ball) - 0.5) < 0.01
    assert first_hit(world) == ball.colliders[0]
    assert drives() == 0 and angles(4).shape == (4,)
    assert len(mistakes(world)) == 3
    again = dim3.World.from_snapshot(world.snapshot())
    assert again.hash == world.copy().hash

    with TemporaryDirectory() as folder:
        pictures: list[NDArray[np.uint8]] = [world.render(64, 36)]
        rapier.Animation(pictures, fps=10).save(Path(folder) / "pile.png")
        rapier.save_picture(f"{folder}/last.png", pictures[-1])
    result: rapier.SweepResult = rapier.sweep(drop, {"height": [1.0, 2.0]}, {"height_after": height}, steps=10, workers=1, progress=False)
    assert [row["height"] for row in result.rows] == [1.0, 2.0]


if __name__ == "__main__":
    main()
