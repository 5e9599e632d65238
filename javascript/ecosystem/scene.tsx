// A scene as users of @react-three/rapier write it: bodies, colliders, joints, sensors, events and queries.

import {
    BallCollider, CuboidCollider, InstancedRigidBodies, Physics, type RapierRigidBody, RigidBody, useRapier, useRopeJoint, useSphericalJoint,
} from "@react-three/rapier";
import { type Renderer, act, advance, createRoot, extend } from "@react-three/fiber";
import { createRef, type RefObject, useEffect } from "react";
import * as THREE from "three";

interface Found {
    ball: RefObject<RapierRigidBody | null>;
    crate: RefObject<RapierRigidBody | null>;
    pendulum: RefObject<RapierRigidBody | null>;
    anchor: RefObject<RapierRigidBody | null>;
    weight: RefObject<RapierRigidBody | null>;
    stones: RefObject<RapierRigidBody[] | null>;
    entered: number;
    contacts: number;
    hit: number | undefined;
}

function Pendulum({ body }: { body: RefObject<RapierRigidBody | null> }) {
    const hook = createRef<RapierRigidBody>() as RefObject<RapierRigidBody>;
    useSphericalJoint(hook, body as RefObject<RapierRigidBody>, [[0, 0, 0], [0, 2, 0]]);
    return (
        <>
            <RigidBody ref={hook} type="fixed" position={[10, 10, 0]} />
            <RigidBody ref={body} position={[12, 10, 0]} rotation={[0, 0, Math.PI / 2]} colliders="cuboid">
                <mesh>
                    <boxGeometry args={[0.5, 1, 0.5]} />
                </mesh>
            </RigidBody>
        </>
    );
}

/** A weight on a rope. The anchor is an empty dynamic body. */
function Rope({ anchor, weight }: { anchor: RefObject<RapierRigidBody | null>; weight: RefObject<RapierRigidBody | null> }) {
    useRopeJoint(anchor as RefObject<RapierRigidBody>, weight as RefObject<RapierRigidBody>, [[0, 0, 0], [0, 0, 0], 2]);
    return (
        <>
            <RigidBody ref={anchor} position={[-10, 10, 0]} />
            <RigidBody ref={weight} position={[-9, 10, 0]} colliders={false}>
                <BallCollider args={[0.5]} />
            </RigidBody>
        </>
    );
}

function Query({ found }: { found: Found }) {
    const { rapier, world } = useRapier();
    useEffect(() => {
        const ray = new rapier.Ray({ x: 20, y: 5, z: 0 }, { x: 0, y: -1, z: 0 });
        found.hit = world.castRay(ray, 100, true)?.timeOfImpact;
    });
    return null;
}

function Scene({ found }: { found: Found }) {
    return (
        <Physics gravity={[0, -9.81, 0]} timeStep={1 / 60} interpolate={false}>
            <CuboidCollider args={[50, 1, 50]} position={[0, -1, 0]} onCollisionEnter={() => (found.contacts += 1)} />
            <RigidBody ref={found.ball} position={[0, 3, 0]} colliders="ball" restitution={0}>
                <mesh>
                    <sphereGeometry args={[0.5]} />
                </mesh>
            </RigidBody>
            <RigidBody ref={found.crate} position={[3, 3, 0]} colliders="hull" linearVelocity={[1, 0, 0]} enabledRotations={[false, false, false]}>
                <mesh>
                    <boxGeometry args={[1, 1, 1]} />
                </mesh>
            </RigidBody>
            <CuboidCollider sensor args={[1, 1, 1]} position={[0, 1, 0]} onIntersectionEnter={() => (found.entered += 1)} />
            <InstancedRigidBodies
                ref={found.stones}
                instances={Array.from({ length: 5 }, (_, key) => ({ key, position: [-5, 1 + 2 * key, 0] as [number, number, number] }))}
                colliders="cuboid"
            >
                <instancedMesh args={[undefined, undefined, 5]} count={5}>
                    <boxGeometry />
                </instancedMesh>
            </InstancedRigidBodies>
            <Pendulum body={found.pendulum} />
            <Rope anchor={found.anchor} weight={found.weight} />
            <Query found={found} />
        </Physics>
    );
}

/** A canvas without a document, and a renderer that draws nothing. */
function offscreen() {
    const canvas = Object.assign(new EventTarget(), { width: 64, height: 64, style: {} }) as unknown as HTMLCanvasElement;
    const events = { addEventListener() {}, removeEventListener() {} };
    const renderer = { domElement: canvas, render() {}, setPixelRatio() {}, setSize() {}, xr: events, shadowMap: {}, capabilities: {}, dispose() {} };
    return { canvas, gl: () => renderer as unknown as Renderer };
}

/** Runs two seconds of the scene. Returns the heights at its end, and what was seen. */
export async function run() {
    const found: Found = { ball: createRef(), crate: createRef(), pendulum: createRef(), anchor: createRef(), weight: createRef(), stones: createRef(), entered: 0, contacts: 0, hit: undefined };
    extend(THREE as unknown as Parameters<typeof extend>[0]);
    const { canvas, gl } = offscreen();
    const root = createRoot(canvas);
    await root.configure({ gl, frameloop: "never", size: { width: 64, height: 64, top: 0, left: 0 } });
    await act(async () => root.render(<Scene found={found} />));
    for (let tries = 0; tries < 50 && !found.ball.current; tries += 1) {
        await act(async () => await new Promise((resolve) => setTimeout(resolve, 10)));
    }
    for (let frame = 1; frame <= 120; frame += 1) {
        advance(frame / 60);
    }
    const height = (body: RefObject<RapierRigidBody | null>) => body.current!.translation().y;
    const result = {
        ball: height(found.ball),
        crate: height(found.crate),
        pendulum: height(found.pendulum),
        anchor: height(found.anchor),
        weight: height(found.weight),
        stones: found.stones.current!.map((stone) => stone.translation().y),
        entered: found.entered,
        contacts: found.contacts,
        hit: found.hit,
    };
    await act(async () => root.unmount());
    return result;
}
