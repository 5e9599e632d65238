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
    with pytest.raises(rapier.SweepError, match="2 workers ended.* with the signal SIGKILL") as error:
        rapier.sweep(fatal, {"height": [1.0, 2.0, 3.0]}, {"end": height_of}, steps=10, workers=2, attempts=2, progress=False)
    result = error.value.result
    assert list(result.failures) == [1] and result.lost_workers == 2
    assert ["end" in row for row in result.rows] == [True, False, True]


def test_an_exception_fails_alone():
    result = rapier.sweep(faulty, {"height": [1.0, 2.0]}, {"end": height_of}, steps=10, workers=1, progress=False, strict=False)
    assert "no such height" in result.failures[1] and "end" in result.rows[0]
    assert "1 failed" in repr(result)


def leaving(height):
    """Ends the worker for the height 2."""
    if height == 2.0:
        os._exit(7)
    return drop(height, 0.0)


def test_the_exit_code_of_a_worker_is_named():
    result = rapier.sweep(leaving, {"height": [1.0, 2.0]}, {"end": height_of}, steps=1, workers=1, attempts=1, progress=False, strict=False)
    assert "the exit code 7" in result.failures[1] and "end" in result.rows[0]


class Unpicklable(Exception):
    """An exception, and a value, without a pickle."""

    def __init__(self, height):
        super().__init__(height)
        self.height = height

    def __reduce__(self):
        raise TypeError("no pickle of it")


def refuse(height):
    if height == 2.0:
        raise Unpicklable(height)
    return drop(height, 0.0)


def unpicklable(world, ball):
    return Unpicklable(0.0) if ball.position[1] > 2.0 else 1.0


def test_values_and_exceptions_without_a_pickle_fail_alone():
    options = {"steps": 1, "workers": 1, "attempts": 1, "progress": False, "strict": False}
    result = rapier.sweep(refuse, {"height": [1.0, 2.0, 3.0]}, {"end": height_of}, **options)
    assert list(result.failures) == [1] and "Unpicklable" in result.failures[1] and result.lost_workers == 0
    result = rapier.sweep(refuse, {"height": [1.0, 3.0]}, {"end": unpicklable}, **options)
    assert list(result.failures) == [1] and "no pickle of it" in result.failures[1] and result.lost_workers == 0
    result = rapier.sweep(refuse, {"height": [1.0, Unpicklable(0.0)]}, {"end": height_of}, **options)
    assert list(result.failures) == [1] and "no pickle of it" in result.failures[1] and result.lost_workers == 0


@pytest.mark.parametrize("grid, metrics, column", [
    ({"height": [1.0]}, {"height": height_of}, "height"), ({"hash": [1.0]}, {"end": height_of}, "hash"),
    ({"height": [1.0]}, {"seconds": height_of}, "seconds"), ([{"height": 1.0}, {"worker": 1}], {"end": height_of}, "worker"),
])
def test_columns_of_one_name_are_refused(grid, metrics, column):
    with pytest.raises(rapier.InvalidValueError, match=f"the column {column} is"):
        rapier.sweep(drop, grid, metrics, steps=1, workers=1, progress=False)


def scaled(world, scale=3.0):
    return scale * len(world)


def keyword(world, *, ball=4.0):
    return ball * len(world)


def test_optional_arguments_of_a_metric_keep_their_defaults():
    result = rapier.sweep(drop, GRID, {"scaled": scaled, "keyword": keyword, "end": height_of}, steps=1, workers=1, progress=False)
    assert [(row["scaled"], row["keyword"]) for row in result.rows] == [(3.0, 4.0)] * 6


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
    # The sweep ends no Ray of its caller.
    assert cluster.is_initialized() and cluster.get(cluster.put(1)) == 1


def test_a_local_cluster_of_a_sweep_ends_with_it(monkeypatch):
    ray = pytest.importorskip("ray")
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).parent))
    assert not ray.is_initialized()
    result = rapier.sweep(drop, {"height": [1.0, 2.0], "restitution": [0.0]}, {"end": height_of}, address="local", steps=60, progress=False)
    assert not ray.is_initialized()
    assert [row["hash"] for row in result.rows] == expected_hashes(result.rows, 60)


def test_an_address_without_a_cluster_is_an_error():
    ray = pytest.importorskip("ray")
    with pytest.raises(ConnectionError):
        rapier.sweep(drop, GRID, {"end": height_of}, address="auto", steps=1, progress=False)
    assert not ray.is_initialized()
