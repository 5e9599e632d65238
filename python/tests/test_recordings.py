"""Recordings of the native engine: replays have equal hashes."""

from pathlib import Path

import numpy as np
import pytest

import rapier
from rapier import dim3

#: The file and the hash of its last step, which `cargo run -p replay --example recording` prints.
RECORDING = Path(__file__).parent / "data/pile.recording"
HASH = 0x4564022E6A70A3C6


def test_a_replay_of_a_native_recording_has_its_hash():
    world = dim3.World.replay(RECORDING.read_bytes())
    assert world.hash == HASH
    assert len(world) == 6 and world.gravity == pytest.approx([3, -9, 0])


def test_a_replayed_world_continues_as_its_copy():
    world = dim3.World.replay(RECORDING.read_bytes())
    other = world.copy()
    for each in (world, other):
        each.step(30)
    assert world.hash == other.hash != HASH
    assert np.array_equal(world.state(), other.state())


def test_damaged_recordings_are_refused():
    recording = RECORDING.read_bytes()
    flipped = bytearray(recording)
    flipped[len(flipped) // 2] ^= 1
    for damaged in (b"", recording[:-1], bytes(flipped), dim3.World().snapshot()):
        with pytest.raises(rapier.SnapshotError):
            dim3.World.replay(damaged)


@pytest.mark.parametrize("name", ["dim2", "dim2_f64", "dim3_f64"])
def test_recordings_of_other_engines_are_refused(name):
    with pytest.raises(rapier.SnapshotError):
        getattr(rapier, name).World.replay(RECORDING.read_bytes())
