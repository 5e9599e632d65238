import { type Vector, getVector, putVector } from "#dim";
import { real, requireFunction } from "./arguments.js";
import type { ColliderHandle } from "./collider.js";
import { SolverFlags } from "./enums.js";
import { type Hook, getNumber, putNumber } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";

/** The kinds of hooks, in the order of crates/wasm/src/hooks.rs. */
const Kind = { contact: 0, intersection: 1, modification: 2 } as const;
/** Bits of the result of a modification. */
const Answer = { keepContacts: 1, computeImpulses: 2, written: 4 } as const;

/** The contacts of a pair, before they are solved. It is valid while the hook runs. */
export class ContactModification {
    /** The normal, from the first collider to the second one. */
    readonly normal: Vector;
    /** The number of contact points. */
    readonly numContacts: number;
    /** The coefficient of friction. */
    friction: number;
    /** The coefficient of restitution. */
    restitution: number;
    /** The velocity of the surface, as of a conveyor belt. */
    tangentVelocity: Vector;
    /** A whole number of 32 bits that the pair keeps as long as it touches. */
    userData: number;
    /** Whether forces are computed. */
    solverFlags: SolverFlags = SolverFlags.COMPUTE_IMPULSE;
    private keep = true;

    /** @internal */
    constructor() {
        this.normal = getVector(0);
        this.tangentVelocity = getVector(1);
        this.friction = getNumber(2, 0);
        this.restitution = getNumber(2, 1);
        this.userData = getNumber(2, 2) + 0x10000 * getNumber(2, 3);
        this.numContacts = getNumber(3, 0);
    }

    /** Removes all contact points. */
    clearContacts(): void {
        this.keep = false;
    }

    /** @internal */
    write(): number {
        putVector(1, this.tangentVelocity, "tangentVelocity");
        putNumber(2, 0, real(this.friction, "friction"));
        putNumber(2, 1, real(this.restitution, "restitution"));
        putNumber(2, 2, this.userData & 0xffff);
        putNumber(2, 3, this.userData >>> 16);
        return Answer.written | (this.keep ? Answer.keepContacts : 0) | computeBit(this.solverFlags);
    }
}

/**
 * Filters pairs and changes contacts during a step. Hooks may read bodies and colliders, but not change them.
 */
export interface PhysicsHooks {
    /**
     * Returns the treatment of a pair by the solver: `EMPTY` computes and reports contacts without forces.
     * Null excludes the pair.
     */
    filterContactPair?(
        collider1: ColliderHandle,
        collider2: ColliderHandle,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ): SolverFlags | null;
    /** Returns whether the intersection of a pair with a sensor is computed. */
    filterIntersectionPair?(
        collider1: ColliderHandle,
        collider2: ColliderHandle,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ): boolean;
    /** Changes the contacts of a pair. Not in the published packages. */
    modifySolverContacts?(
        contacts: ContactModification,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ): void;
}

/** Returns the bits of the present hooks. */
export function presentHooks(hooks: PhysicsHooks): number {
    const present = (name: keyof PhysicsHooks, kind: number): number => {
        if (!hooks[name]) {
            return 0;
        }
        requireFunction(hooks[name], `hooks.${name}`);
        return 1 << kind;
    };
    return (
        present("filterContactPair", Kind.contact) |
        present("filterIntersectionPair", Kind.intersection) |
        present("modifySolverContacts", Kind.modification)
    );
}

/** Returns the bits of a filter's result. */
function pairAnswer(flags: SolverFlags | null): number {
    return flags === null ? 0 : Answer.keepContacts | computeBit(flags);
}

function computeBit(flags: SolverFlags): number {
    return flags & SolverFlags.COMPUTE_IMPULSE ? Answer.computeImpulses : 0;
}

/** The function that the module calls. */
export function hookOf(hooks: PhysicsHooks): Hook {
    return (kind, collider1, collider2, body1, body2) => {
        switch (kind) {
            case Kind.contact:
                return pairAnswer(hooks.filterContactPair!(collider1, collider2, body1, body2));
            case Kind.intersection:
                return +hooks.filterIntersectionPair!(collider1, collider2, body1, body2);
            default: {
                const contacts = new ContactModification();
                hooks.modifySolverContacts!(contacts, collider1, collider2, body1, body2);
                return contacts.write();
            }
        }
    };
}
