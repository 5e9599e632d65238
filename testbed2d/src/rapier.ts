// The engine's types. The module itself comes as a value, so that each engine runs the same scenes.

import type * as RAPIER from "@dimforge/rapier2d-compat";
import type { Camera, Claim, Paint, Parameter, Pen, SceneContext, SceneDefinition, SceneRun } from "../../testbed/src/core/scene.ts";

export type Rapier = typeof RAPIER;
export type World = RAPIER.World;
export type RigidBody = RAPIER.RigidBody;
export type Collider = RAPIER.Collider;
export type ColliderDesc = RAPIER.ColliderDesc;
export type RigidBodyDesc = RAPIER.RigidBodyDesc;
export type ImpulseJoint = RAPIER.ImpulseJoint;
export type RevoluteImpulseJoint = RAPIER.RevoluteImpulseJoint;
export type PrismaticImpulseJoint = RAPIER.PrismaticImpulseJoint;
export type Shape = RAPIER.Shape;
export type Vector = RAPIER.Vector;
export type Rotation = RAPIER.Rotation;
export type EventQueue = RAPIER.EventQueue;
export type PhysicsHooks = RAPIER.PhysicsHooks;

export type Context = SceneContext<Rapier, World>;
export type Run = SceneRun<EventQueue, PhysicsHooks>;
export type { Camera, Claim, Paint, Parameter, Pen };

export interface Scene extends SceneDefinition<Rapier, World> {
    setup(context: Context): Run | void;
}
