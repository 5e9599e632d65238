# By name: with a star, type checkers would keep the classes of two dimensions.
from ._engine import (
    DIM as DIM, STATE as STATE, Body as Body, CharacterController as CharacterController, CharacterMovement as CharacterMovement, Collider as Collider,
    CollisionEvent as CollisionEvent, Contact as Contact, Joint as Joint, Pair as Pair, PointProjection as PointProjection, RayHit as RayHit, Shape as Shape,
    dtype as dtype,
)
from ._vehicle import Vehicle as Vehicle
from ._vehicle import World as World
from ._vehicle import WorldBatch as WorldBatch
