# The classes of rapier.dim3 and rapier.dim3_f64 alone.

from collections.abc import Sequence
from typing import Any, Optional, Union

from numpy.typing import ArrayLike, NDArray

from . import _engine
from ._engine import Body

_Vector = Union[Sequence[float], NDArray[Any]]

class Vehicle:
    controls: NDArray[Any]
    def __len__(self) -> int: ...
    def add_wheel(
        self, connection: _Vector, *, rest_length: float, radius: float, direction: Optional[_Vector] = None, axle: Optional[_Vector] = None,
        stiffness: float = 5.88, compression: float = 0.83, relaxation: float = 0.88, travel: float = 5.0, grip: float = 10.5, side_grip: float = 1.0,
        max_force: float = 6000.0, roll_influence: float = 0.1,
    ) -> int: ...
    def control(self, wheel: int, *, engine: Optional[float] = None, brake: Optional[float] = None, steering: Optional[float] = None) -> None: ...
    @property
    def speed(self) -> float: ...
    @property
    def on_ground(self) -> list[bool]: ...
    @property
    def wheel_positions(self) -> NDArray[Any]: ...
    def remove(self) -> None: ...

class World(_engine.World):
    def add_vehicle(self, chassis: Body) -> Vehicle: ...

class WorldBatch(_engine.WorldBatch):
    def set_vehicle_controls(self, vehicle: Vehicle, controls: ArrayLike) -> None: ...
