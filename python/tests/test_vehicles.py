"""Vehicles: they drive, brake and steer, in worlds, copies and batches."""

import copy
import pickle

import numpy as np
import pytest

import rapier


@pytest.fixture(params=["dim3", "dim3_f64"])
def engine(request):
    return getattr(rapier, request.param)


def make_car(engine):
    """A car of 1000 kg on a plane. It looks along x."""
    world = engine.World()
    world.add_collider(engine.Shape.box([200, 0.5, 200]), position=[0, -0.5, 0])
    chassis = world.add_body(shape=engine.Shape.box([2, 0.3, 0.9]), mass=1000.0, position=[0, 0.84, 0], can_sleep=False)
    car = world.add_vehicle(chassis)
    for x, z in [(1.3, -0.8), (1.3, 0.8), (-1.3, -0.8), (-1.3, 0.8)]:
        car.add_wheel([x, -0.2, z], rest_length=0.4, radius=0.3, stiffness=40.0, compression=2.0, relaxation=3.0, grip=1.0)
    return world, chassis, car


def test_the_engine_accelerates_by_the_formula(engine):
    world, chassis, car = make_car(engine)
    controls = np.zeros((4, 3))
    controls[:, 0] = 500.0  # 2000 N on 1000 kg
    car.controls = controls
    world.step(60)
    assert chassis.linvel[0] == pytest.approx(2.0, abs=0.1)
    assert car.speed == pytest.approx(2.0, abs=0.1)
    assert car.on_ground == [True] * 4 and len(car) == 4
    assert car.controls == pytest.approx(controls)
    assert car.wheel_positions[:, 0] == pytest.approx([1.3, 1.3, -1.3, -1.3])


def test_brakes_stop_by_the_formula(engine):
    world, chassis, car = make_car(engine)
    world.step(60)
    chassis.linvel = [10.0, 0.0, 0.0]
    for wheel in range(4):
        car.control(wheel, brake=1000.0)
    begin = chassis.position[0]
    world.step(300)
    # 4000 N on 1000 kg: v²/(2a).
    assert chassis.position[0] - begin == pytest.approx(100 / 8, rel=0.05)
    assert abs(chassis.linvel[0]) < 0.01


@pytest.mark.parametrize("rate", [60, 240])
def test_brakes_are_independent_of_the_rate(engine, rate):
    world, chassis, car = make_car(engine)
    world.step(60)
    chassis.linvel = [10.0, 0.0, 0.0]
    # The controls are set before the length of the step.
    for wheel in range(4):
        car.control(wheel, brake=1000.0)
    world.dt = 1 / rate
    assert car.controls[:, 1] == pytest.approx([1000.0] * 4)
    world.step(rate)
    # 4000 N on 1000 kg for 1 s.
    assert chassis.linvel[0] == pytest.approx(6.0, abs=0.2)


@pytest.mark.parametrize("rate", [60, 240])
def test_brakes_of_a_batch_are_independent_of_the_rate(engine, rate):
    world, chassis, car = make_car(engine)
    world.step(60)
    chassis.linvel = [10.0, 0.0, 0.0]
    world.dt = 1 / rate
    batch = engine.WorldBatch(world, 2)
    controls = np.zeros((2, 4, 3))
    controls[1, :, 1] = 1000.0
    batch.set_vehicle_controls(car, controls)
    batch.step(rate)
    assert batch.state()[:, 0, 7] == pytest.approx([10.0, 6.0], abs=0.2)


def test_steering_turns_to_the_left(engine):
    world, chassis, car = make_car(engine)
    for wheel in (0, 1):
        car.control(wheel, engine=500.0, steering=0.3)
    world.step(180)
    assert chassis.angvel[1] > 0.1 and chassis.position[2] < -0.1


@pytest.mark.parametrize("way", ["pickle", "copy", "deepcopy"])
def test_a_copy_continues_bit_by_bit(engine, way):
    world, _, car = make_car(engine)
    car.control(0, engine=500.0, steering=0.1)
    world.step(30)
    copies = {"pickle": lambda: pickle.loads(pickle.dumps(world)), "copy": world.copy, "deepcopy": lambda: copy.deepcopy(world)}
    other = copies[way]()
    for _ in range(30):
        world.step()
        other.step()
        assert world.hash == other.hash


def test_a_batch_drives_each_car_with_its_controls(engine):
    world, chassis, car = make_car(engine)
    batch = engine.WorldBatch(world, 3)
    controls = np.zeros((3, 4, 3))
    controls[:, :, 0] = [[0.0], [250.0], [500.0]]
    batch.set_vehicle_controls(car, controls)
    batch.step(60)
    assert batch.state()[:, 0, 7] == pytest.approx([0.0, 1.0, 2.0], abs=0.1)
    car.controls = controls[2]
    world.step(60)
    assert batch.hashes()[2] == world.hash
    batch.reset()
    batch.step(60)
    assert np.abs(batch.state()[:, 0, 7]).max() < 1e-3


def test_a_removed_vehicle_raises_and_leaves_its_chassis(engine):
    world, chassis, car = make_car(engine)
    car.remove()
    world.step(120)
    assert chassis.position[1] == pytest.approx(0.3, abs=0.01)
    for use in (lambda: len(car), lambda: car.speed, car.remove):
        with pytest.raises(rapier.StaleHandleError, match="vehicle"):
            use()


def test_invalid_values_are_refused(engine):
    world, chassis, car = make_car(engine)
    with pytest.raises(rapier.InvalidValueError, match="wheel is 4"):
        car.control(4, engine=1.0)
    with pytest.raises(rapier.InvalidValueError, match="brake is -1"):
        car.control(0, brake=-1.0)
    with pytest.raises(rapier.InvalidValueError, match="brake force"):
        car.controls = -np.ones((4, 3))
    with pytest.raises(rapier.InvalidValueError, match="radius is NaN"):
        car.add_wheel([0, 0, 0], rest_length=0.4, radius=float("nan"))
    with pytest.raises(rapier.InvalidValueError, match="dynamic"):
        world.add_vehicle(world.add_body("fixed"))
    with pytest.raises(rapier.InvalidValueError, match="another world"):
        engine.WorldBatch(world, 1).set_vehicle_controls(make_car(engine)[2], np.zeros((1, 4, 3)))


def test_pictures_contain_the_wheels(engine):
    world, _, car = make_car(engine)
    world.step()
    focus = ([-2, 0, -1], [2, 1.5, 1])
    whole = world.render(160, 90, focus=focus)
    car.remove()
    assert np.count_nonzero((whole != world.render(160, 90, focus=focus)).any(axis=2)) > 50
