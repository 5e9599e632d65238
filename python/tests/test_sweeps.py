"""Sweeps: results equal those of single worlds, and survive the loss of workers."""

import os
import signal
from pathlib import Path

import pytest

import rapier
from rapier import dim2

GRID = {"height": [1.0, 2.0, 4.0], "restitution": [0.0, 0.5]}


def drop(height, restitution):
    """A ball above a ground, and the ball."""
    world = dim2.World()
    world.add_collider(dim2.Shape.halfspace([0, 1]), restitution=restitution)
    return world, world.add_body(shape=dim2.Shape.ball(0.5), position=[0, height + 0.5], restitution=restitution, can_sleep=False)


def fragile(height, restitution, folder):
    """The same. The first worker that gets the case kills itself."""
    mark = Path(folder) / f"{height}-{restitution}"
    if height == 2.0 and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return drop(height, restitution)


def fatal(height):
    """Each worker that gets the height 2 kills itself."""
    if height == 2.0:
        os.kill(os.getpid(), signal.SIGKILL)
    return drop(height, 0.0)


def faulty(height):
    """Raises for the height 2."""
    if height == 2.0:
        raise ArithmeticError("no such height")
    return drop(height, 0.0)


def height_of(world, ball):
    return ball.position[1]


def body_count(world):
    return len(world)


def expected_hashes(cases, steps):
    hashes = []
    for case in cases:
        world, _ = drop(case["height"], case["restitution"])
        world.step(steps)
        hashes.append(world.hash)
    return hashes


def test_a_sweep_gives_the_bits_of_single_worlds():
    result = rapier.sweep(drop, GRID, {"end": height_of, "bodies": body_count}, steps=60, workers=2, progress=False)
    assert len(result) == 6 and result.parameters == ["height", "restitution"]
    assert [row["hash"] for row in result.rows] == expected_hashes(result.rows, 60)
    assert [row["bodies"] for row in result.rows] == [1] * 6
    assert [(row["height"], row["restitution"]) for row in result.rows][:3] == [(1.0, 0.0), (1.0, 0.5), (2.0, 0.0)]


def test_a_killed_worker_loses_nothing(tmp_path):
    grid = {**GRID, "folder": [str(tmp_path)]}
    result = rapier.sweep(fragile, grid, {"end": height_of}, steps=60, workers=2, progress=False)
    assert result.lost_workers == 2 and not result.failures
    assert [row["hash"] for row in result.rows] == expected_hashes(result.rows, 60)


def test_a_case_that_kills_all_workers_fails_alone():
    with pytest.raises(rapier.SweepError, match="2 workers ended") as error:
        rapier.sweep(fatal, {"height": [1.0, 2.0, 3.0]}, {"end": height_of}, steps=10, workers=2, attempts=2, progress=False)
    result = error.value.result
    assert list(result.failures) == [1] and result.lost_workers == 2
    assert ["end" in row for row in result.rows] == [True, False, True]


def test_an_exception_fails_alone():
    result = rapier.sweep(faulty, {"height": [1.0, 2.0]}, {"end": height_of}, steps=10, workers=1, progress=False, strict=False)
    assert "no such height" in result.failures[1] and "end" in result.rows[0]
    assert "1 failed" in repr(result)


def test_a_world_is_copied_for_each_case():
    world, _ = drop(5.0, 0.0)
    result = rapier.sweep(world, {"gravity": [[0, -1], [0, -2]]}, {"fallen": lowest}, steps=30, workers=1, progress=False)
    assert result.rows[0]["fallen"] > result.rows[1]["fallen"]
    with pytest.raises(rapier.SweepError, match="no property"):
        rapier.sweep(world, {"color": [1]}, {"fallen": lowest}, steps=1, workers=1, progress=False)


def lowest(world):
    return world.state()[:, 1].min()


def test_the_table_is_arrow_and_parquet(tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    import pyarrow.parquet

    result = rapier.sweep(drop, GRID, {"end": height_of}, steps=10, workers=1, progress=False)
    result.to_parquet(tmp_path / "drop.parquet")
    table = pyarrow.parquet.read_table(tmp_path / "drop.parquet")
    assert table.num_rows == 6 and table.column_names[:3] == ["height", "restitution", "end"]
    assert table["hash"].to_pylist() == [row["hash"] for row in result.rows]


def test_a_plot_has_a_line_for_each_value():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    result = rapier.sweep(drop, GRID, {"end": height_of}, steps=10, workers=1, progress=False)
    axes = result.plot()
    assert len(axes.lines) == 2 and list(axes.lines[0].get_xdata()) == [1.0, 2.0, 4.0]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("height", "end")


@pytest.fixture
def cluster():
    ray = pytest.importorskip("ray")
    environment = {"env_vars": {"PYTHONPATH": str(Path(__file__).parent)}}
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, runtime_env=environment)
    yield ray
    ray.shutdown()


def test_a_cluster_gives_the_same_bits_and_survives_a_killed_worker(cluster, tmp_path):
    grid = {**GRID, "folder": [str(tmp_path)]}
    result = rapier.sweep(fragile, grid, {"end": height_of}, address="auto", steps=60, progress=False)
    assert not result.failures and len(list(tmp_path.iterdir())) == 2
    assert [row["hash"] for row in result.rows] == expected_hashes(result.rows, 60)
    assert len({row["worker"] for row in result.rows}) >= 2
