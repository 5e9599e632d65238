from . import dim2 as dim2
from . import dim2_f64 as dim2_f64
from . import dim3 as dim3
from . import dim3_f64 as dim3_f64

from .pictures import Animation as Animation
from .pictures import save_picture as save_picture
from .sweeps import SweepError as SweepError
from .sweeps import SweepResult as SweepResult
from .sweeps import sweep as sweep

__version__: str

class RapierError(Exception): ...
class StaleHandleError(RapierError): ...
class InvalidValueError(RapierError, ValueError): ...
class SnapshotError(RapierError): ...
