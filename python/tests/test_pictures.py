"""Pictures: arrays, PNG and APNG."""

import io

import numpy as np
import pytest
from conftest import at, make_pile

import rapier

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def test_a_picture_shows_the_bodies(engine):
    world = engine.World()
    empty = world.render(64, 48, focus=(at(engine, -1, -1, -1), at(engine, 1, 1, 1)))
    assert empty.shape == (48, 64, 3) and empty.dtype == np.uint8
    world.add_body(shape=engine.Shape.ball(0.5))
    world.step()
    picture = world.render(64, 48, focus=(at(engine, -1, -1, -1), at(engine, 1, 1, 1)))
    changed = (picture != empty).any(axis=2)
    assert changed[24, 32] and not changed[0, 0]
    assert 0.02 < changed.mean() < 0.5


def test_equal_worlds_give_equal_pictures(engine):
    world = make_pile(engine)
    world.step(30)
    assert np.array_equal(world.render(96, 64), world.copy().render(96, 64))


def test_pictures_and_debug_lines_show_changed_poses_before_a_step(engine):
    def make(x):
        world = engine.World()
        world.add_body(shape=engine.Shape.ball(0.5), position=at(engine, x, 0))
        return world

    focus = (at(engine, -1, -1, -1), at(engine, 3, 1, 1))
    expected = make(2)
    picture, lines = expected.render(64, 48, focus=focus), expected.debug_lines()[0]
    batch = engine.WorldBatch(make(0), 2)
    before = batch.render(1, 64, 48, focus=focus)
    assert not np.array_equal(before, picture)
    state = batch.state()
    state[1, 0, 0] = 2.0
    batch.set_state(state)
    assert np.array_equal(batch.render(0, 64, 48, focus=focus), before)
    assert np.array_equal(batch.render(1, 64, 48, focus=focus), picture)
    assert np.array_equal(batch.world(1).debug_lines()[0], lines)
    world = make(0)
    assert np.array_equal(world.render(64, 48, focus=focus), before)
    world.bodies[0].position = at(engine, 2, 0)
    assert np.array_equal(world.render(64, 48, focus=focus), picture)


def test_single_and_double_precision_look_alike():
    for dimension in ("dim2", "dim3"):
        pictures = []
        for name in (dimension, f"{dimension}_f64"):
            world = make_pile(getattr(rapier, name), 6)
            world.step()
            pictures.append(world.render(96, 64).astype(int))
        assert np.abs(pictures[0] - pictures[1]).mean() < 0.5


def test_the_camera_turns():
    world = make_pile(rapier.dim3)
    world.step()
    assert not np.array_equal(world.render(64, 48, yaw=0), world.render(64, 48, yaw=90))
    assert not np.array_equal(world.render(64, 48, pitch=0), world.render(64, 48, pitch=60))


def test_notebooks_get_a_png(engine):
    assert make_pile(engine, 3)._repr_png_().startswith(SIGNATURE)


def test_a_saved_picture_has_its_pixels(tmp_path):
    image = pytest.importorskip("PIL.Image")
    picture = make_pile(rapier.dim3).render(40, 30)
    rapier.save_picture(tmp_path / "pile.png", picture)
    with image.open(tmp_path / "pile.png") as saved:
        assert np.array_equal(np.asarray(saved), picture)


def test_a_moving_picture_has_its_frames(tmp_path):
    world = make_pile(rapier.dim3, 8)
    animation = rapier.Animation(fps=20)
    for _ in range(5):
        world.step(4)
        animation.append(world.render(64, 48, focus=([-2, 0, -2], [5, 4, 2])))
    animation.save(tmp_path / "pile.png")
    data = (tmp_path / "pile.png").read_bytes()
    assert data.startswith(SIGNATURE) and data == animation._repr_png_()
    image = pytest.importorskip("PIL.Image")
    with image.open(io.BytesIO(data)) as saved:
        assert saved.n_frames == len(animation) == 5 and saved.size == (64, 48)


def test_invalid_pictures_are_refused(engine):
    world = engine.World()
    for size in ((0, 10), (10, 0), (1 << 20, 1 << 20)):
        with pytest.raises(rapier.InvalidValueError, match="pixels"):
            world.render(*size)
    with pytest.raises(rapier.InvalidValueError, match="yaw is NaN"):
        world.render(8, 8, yaw=float("nan"))
    with pytest.raises(rapier.InvalidValueError, match="frames"):
        rapier.Animation().to_bytes()
    with pytest.raises(rapier.InvalidValueError, match=r"frames\[1\]"):
        rapier.Animation([np.zeros((4, 4, 3), np.uint8), np.zeros((4, 5, 3), np.uint8)]).to_bytes()
    with pytest.raises(rapier.InvalidValueError, match="picture"):
        rapier.save_picture("unused.png", np.zeros((4, 4), np.uint8))
