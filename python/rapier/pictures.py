"""Pictures and moving pictures: PNG and APNG, from the arrays of ``World.render``."""

import os
from collections.abc import Iterable
from typing import Optional, Union

import numpy as np
from numpy.typing import NDArray

from ._rapier import encode_apng, encode_png

_Path = Union[str, os.PathLike[str]]


def save_picture(path: _Path, picture: NDArray[np.uint8]) -> None:
    """Writes an array of the shape (height, width, 3) with bytes of red, green and blue as a PNG file."""
    data = encode_png(np.ascontiguousarray(picture))
    with open(path, "wb") as file:
        file.write(data)


class Animation:
    """A moving picture that repeats without end. A notebook shows it as the value of a cell.

    frames: arrays of one shape (height, width, 3) with bytes of red, green and blue. fps: frames per second.
    """

    def __init__(self, frames: Iterable[NDArray[np.uint8]] = (), fps: int = 30) -> None:
        self.frames = list(frames)
        self.fps = fps

    def __len__(self) -> int:
        """The number of frames."""
        return len(self.frames)

    def append(self, frame: NDArray[np.uint8]) -> None:
        """Adds a frame."""
        self.frames.append(frame)

    def to_bytes(self) -> bytes:
        """The bytes of an APNG file. Frames after the first contain the changed pixels alone, in a palette of 255 colours."""
        return encode_apng([np.ascontiguousarray(frame) for frame in self.frames], self.fps)

    def save(self, path: _Path) -> None:
        """Writes an APNG file. Browsers play it, and other programs show its first frame."""
        data = self.to_bytes()
        with open(path, "wb") as file:
            file.write(data)

    def _repr_png_(self) -> Optional[bytes]:
        return self.to_bytes() if self.frames else None

    def __repr__(self) -> str:
        return f"<Animation: {len(self.frames)} frames, {self.fps} per second>"
