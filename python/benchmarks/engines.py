"""One description of a scene for three engines: rapier, MuJoCo and PyBullet. y is up, and each body has its centre of mass at its origin."""

from dataclasses import dataclass

import numpy as np

import rapier

GRAVITY = 9.81


@dataclass
class Part:
    """A body, and the joint that holds it: to another part, or with the parent -1 to the world.

    size: half extents of a box, or one radius of a ball (m). joint: "free", "hinge", "ball" or "slide". anchor, axis: of the joint (m, world), at the begin.
    """

    size: tuple
    mass: float
    position: tuple
    linvel: tuple = (0.0, 0.0, 0.0)
    angvel: tuple = (0.0, 0.0, 0.0)
    joint: str = "free"
    parent: int = -1
    anchor: tuple = (0.0, 0.0, 0.0)
    axis: tuple = (0.0, 0.0, 1.0)

    @property
    def inertia(self):
        """Principal moments (kg m²)."""
        if len(self.size) == 1:
            return np.full(3, 0.4 * self.mass * self.size[0] ** 2)
        squares = np.square(self.size)
        return self.mass / 3.0 * (squares.sum() - squares)


@dataclass
class Scene:
    """Parts, a plane below them, and the coefficient of friction of all contacts."""

    parts: list
    plane: bool = False
    friction: float = 0.5
    gravity: tuple = (0.0, -GRAVITY, 0.0)


class Engine:
    """A scene in an engine. `states` are rows of position (3), quaternion x y z w (4), linear and angular velocity (3 each)."""

    name = ""

    def __init__(self, scene, dt):
        raise NotImplementedError

    def step(self, count):
        raise NotImplementedError

    def states(self):
        raise NotImplementedError


class Rapier(Engine):
    """Joints are those of reduced coordinates."""

    name = "rapier f64"
    module = rapier.dim3_f64

    def __init__(self, scene, dt):
        module = self.module
        self.world = module.World(gravity=scene.gravity, dt=dt)
        if scene.plane:
            self.world.add_collider(module.Shape.box([100, 1, 100]), position=[0, -1, 0], friction=scene.friction)
        root = self.world.add_body("fixed") if any(part.joint != "free" for part in scene.parts) else None
        self.bodies = []
        for part in scene.parts:
            shape = module.Shape.ball(*part.size) if len(part.size) == 1 else module.Shape.box(part.size)
            groups = {} if part.joint == "free" else {"collision_groups": (0, 0)}
            self.bodies.append(
                self.world.add_body(
                    shape=shape, mass=part.mass, position=part.position, linvel=part.linvel, angvel=part.angvel, friction=scene.friction, can_sleep=False, **groups,
                )
            )
        for part, body in zip(scene.parts, self.bodies):
            if part.joint == "free":
                continue
            parent, origin = (root, np.zeros(3)) if part.parent < 0 else (self.bodies[part.parent], np.array(scene.parts[part.parent].position))
            kind = {"hinge": "revolute", "ball": "spherical", "slide": "prismatic"}[part.joint]
            axis = {} if kind == "spherical" else {"axis": part.axis}
            anchors = {"anchor1": np.array(part.anchor) - origin, "anchor2": np.array(part.anchor) - part.position}
            self.world.add_joint(kind, parent, body, reduced=True, contacts=False, **anchors, **axis)

    def step(self, count):
        self.world.step(count)

    def states(self):
        state = self.world.state()
        return state[-len(self.bodies) :].astype(float)


class RapierSingle(Rapier):
    name = "rapier f32"
    module = rapier.dim3


class MuJoCo(Engine):
    """The semi-implicit integrator, as in the other engines."""

    name = "MuJoCo"
    integrator = "Euler"

    def __init__(self, scene, dt):
        import mujoco

        self.mujoco, self.scene = mujoco, scene
        gravity = " ".join(map(str, scene.gravity))
        text = f'<mujoco><option timestep="{dt}" gravity="{gravity}" integrator="{self.integrator}"/><worldbody>'
        if scene.plane:
            text += f'<geom type="box" size="100 1 100" pos="0 -1 0" friction="{scene.friction}"/>'
        text += "".join(self.xml(number) for number, part in enumerate(scene.parts) if part.parent < 0)
        self.model = mujoco.MjModel.from_xml_string(text + "</worldbody></mujoco>")
        self.data = mujoco.MjData(self.model)
        for number, part in enumerate(scene.parts):
            joint = self.model.joint(f"j{number}")
            first = joint.dofadr[0]
            if part.joint == "free":
                self.data.qvel[first : first + 6] = [*part.linvel, *part.angvel]
            elif part.joint == "ball":
                self.data.qvel[first : first + 3] = part.angvel

    def xml(self, number):
        part = self.scene.parts[number]
        origin = np.zeros(3) if part.parent < 0 else np.array(self.scene.parts[part.parent].position)

        def words(values):
            return " ".join(map(str, values))

        kind = {"free": "free", "hinge": "hinge", "ball": "ball", "slide": "slide"}[part.joint]
        joint = f'<joint name="j{number}" type="{kind}"'
        if kind in ("hinge", "slide"):
            joint += f' axis="{words(part.axis)}"'
        joint += "/>" if kind == "free" else f' pos="{words(np.array(part.anchor) - part.position)}"/>'
        shape = "sphere" if len(part.size) == 1 else "box"
        contacts = "" if part.joint == "free" else ' contype="0" conaffinity="0"'
        inner = "".join(self.xml(other) for other, child in enumerate(self.scene.parts) if child.parent == number)
        return (
            f'<body name="b{number}" pos="{words(np.array(part.position) - origin)}">{joint}<inertial pos="0 0 0" mass="{part.mass}" diaginertia="{words(part.inertia)}"/>'
            f'<geom type="{shape}" size="{words(part.size)}" friction="{self.scene.friction}"{contacts}/>{inner}</body>'
        )

    def step(self, count):
        self.mujoco.mj_step(self.model, self.data, count)

    def states(self):
        mujoco, data = self.mujoco, self.data
        mujoco.mj_forward(self.model, data)
        rows, velocity = [], np.zeros(6)
        for number in range(len(self.scene.parts)):
            body = self.model.body(f"b{number}").id
            mujoco.mj_objectVelocity(self.model, data, mujoco.mjtObj.mjOBJ_BODY, body, velocity, 0)
            w, x, y, z = data.xquat[body]
            rows.append([*data.xpos[body], x, y, z, w, *velocity[3:], *velocity[:3]])
        return np.array(rows)


class MuJoCoRk4(MuJoCo):
    name = "MuJoCo RK4"
    integrator = "RK4"


class PyBullet(Engine):
    """Its bodies are multibodies, with all damping off."""

    name = "PyBullet"

    def __init__(self, scene, dt):
        import pybullet
        from pybullet_utils.bullet_client import BulletClient

        self.scene = scene
        self.client = client = BulletClient(pybullet.DIRECT)
        client.setGravity(*scene.gravity)
        client.setTimeStep(dt)
        if scene.plane:
            shape = client.createCollisionShape(client.GEOM_BOX, halfExtents=[100, 1, 100])
            ground = client.createMultiBody(0, shape, basePosition=[0, -1, 0])
            client.changeDynamics(ground, -1, lateralFriction=1.0)
        self.places = {}
        for number, part in enumerate(scene.parts):
            if part.joint == "free":
                self.places[number] = (client.createMultiBody(part.mass, self.shape(part), basePosition=part.position), -1)
                client.resetBaseVelocity(self.places[number][0], part.linvel, part.angvel)
        tree = [number for number, part in enumerate(scene.parts) if part.joint != "free"]
        if tree:
            self.add_tree(tree)
        for number, (body, link) in self.places.items():
            # Bullet multiplies the coefficients of both sides.
            options = {"lateralFriction": scene.friction, "rollingFriction": 0.0, "spinningFriction": 0.0}
            inertia = list(scene.parts[number].inertia)
            client.changeDynamics(body, link, linearDamping=0, angularDamping=0, jointDamping=0, maxJointVelocity=1e6, localInertiaDiagonal=inertia, **options)

    def shape(self, part):
        client = self.client
        if len(part.size) == 1:
            return client.createCollisionShape(client.GEOM_SPHERE, radius=part.size[0])
        return client.createCollisionShape(client.GEOM_BOX, halfExtents=part.size)

    def add_tree(self, tree):
        client, parts = self.client, self.scene.parts
        kinds = {"hinge": client.JOINT_REVOLUTE, "ball": client.JOINT_SPHERICAL, "slide": client.JOINT_PRISMATIC}
        anchors = {number: np.array(parts[number].anchor) for number in tree}
        origin = {number: np.zeros(3) if parts[number].parent < 0 else anchors[parts[number].parent] for number in tree}
        body = client.createMultiBody(
            0, -1, basePosition=[0, 0, 0],
            linkMasses=[parts[number].mass for number in tree],
            linkCollisionShapeIndices=[self.shape(parts[number]) for number in tree], linkVisualShapeIndices=[-1] * len(tree),
            linkPositions=[list(anchors[number] - origin[number]) for number in tree], linkOrientations=[[0, 0, 0, 1]] * len(tree),
            linkInertialFramePositions=[list(np.array(parts[number].position) - anchors[number]) for number in tree],
            linkInertialFrameOrientations=[[0, 0, 0, 1]] * len(tree),
            linkParentIndices=[0 if parts[number].parent < 0 else tree.index(parts[number].parent) + 1 for number in tree],
            linkJointTypes=[kinds[parts[number].joint] for number in tree], linkJointAxis=[parts[number].axis for number in tree],
        )
        for link, number in enumerate(tree):
            self.places[number] = (body, link)
            # Links without a shape have no inertia, and ball joints then give no numbers.
            client.setCollisionFilterGroupMask(body, link, 0, 0)
            if parts[number].joint == "ball":
                client.setJointMotorControlMultiDof(body, link, client.POSITION_CONTROL, targetPosition=[0, 0, 0, 1], targetVelocity=[0, 0, 0], positionGain=0, velocityGain=1, force=[0, 0, 0])
                client.resetJointStateMultiDof(body, link, [0, 0, 0, 1], parts[number].angvel)
            else:
                client.setJointMotorControl2(body, link, client.VELOCITY_CONTROL, force=0)

    def step(self, count):
        for _ in range(count):
            self.client.stepSimulation()

    def states(self):
        client, rows = self.client, []
        for number in range(len(self.scene.parts)):
            body, link = self.places[number]
            if link < 0:
                rows.append([*sum(client.getBasePositionAndOrientation(body), ()), *sum(client.getBaseVelocity(body), ())])
            else:
                state = client.getLinkState(body, link, computeLinkVelocity=1, computeForwardKinematics=1)
                rows.append([*state[0], *state[1], *state[6], *state[7]])
        return np.array(rows)


ENGINES = [RapierSingle, Rapier, MuJoCo, MuJoCoRk4, PyBullet]
