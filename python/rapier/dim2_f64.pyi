from ._engine import *
