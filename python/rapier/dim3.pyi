from ._engine import *
from ._vehicle import Vehicle as Vehicle
from ._vehicle import World as World
from ._vehicle import WorldBatch as WorldBatch
