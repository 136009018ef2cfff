"""MuJoCo as a second route to equations of motion: planar models in MJCF, brought to independent coordinates.

MuJoCo's constraints are soft, so its solver is left out. The unconstrained tree gives the joint forces f = M p̈ + h − Q
of inverse dynamics; the constraints enter by MuJoCo's values and Jacobian of them. With the rows S of the coordinates
q = S p and the constraints G(p) = 0, J = ∂G/∂p, the motion is ṗ = B q̇, p̈ = B q̈ + b, and the residual of each
coordinate is Bᵀ f. The figure lies in the plane z = 0; joints and coordinates are zero as drawn, in SI units.
"""

import numpy as np

TINY = 1e-14            # inertia of a particle; MuJoCo refuses none
SHARES, CLOSED, DEPENDENT = (0.25, 0.5, 0.75, 1.0), 1e-14, 1e-9
STENCIL = ((1, 45 / 60), (2, -9 / 60), (3, 1 / 60))     # first derivative, of the sixth order
NEAR, ALONG = 1e-3, 1e-2


# MJCF

def body(x, y, *parts, name=""):
    """A body with its frame drawn at (x, y) in that of its parent; places within it count from there."""
    return f'<body {named(name)}pos="{x} {y} 0">{"".join(parts)}</body>'


def named(name):
    return f'name="{name}" ' if name else ""


def hinge(name, x=0, y=0, k=0, c=0):
    return f'<joint name="{name}" type="hinge" axis="0 0 1" pos="{x} {y} 0" stiffness="{k}" damping="{c}"/>'


def slide(name, x, y, k=0, c=0, free=0):
    """Along the direction (x, y), with a spring that is free at the displacement `free`."""
    return f'<joint name="{name}" type="slide" axis="{x} {y} 0" stiffness="{k}" damping="{c}" springref="{free}"/>'


def mass(m, J=TINY, x=0, y=0):
    """Mass m at (x, y) with the moment of inertia J about it."""
    return f'<inertial pos="{x} {y} 0" mass="{m}" diaginertia="{J} {J} {J}"/>'


def rod(m, x, y):
    """A uniform rod from the body's origin to (x, y)."""
    return mass(m, m * (x * x + y * y) / 12, x / 2, y / 2)


def disc(m, r, x=0, y=0):
    return mass(m, m * r * r / 2, x, y)


def site(name, x=0, y=0):
    return f'<site name="{name}" pos="{x} {y} 0"/>'


def pulley(name, r, x=0, y=0):
    """A smooth cylinder that ropes run around; it has no mass."""
    return f'<geom name="{name}" type="cylinder" pos="{x} {y} 0" size="{r} 0.01" mass="0"/>'


def spring(one, two, k=0, free=0, c=0):
    """A spring of free length `free`, or a damper, between two sites."""
    return (f'<spatial stiffness="{k}" springlength="{free}" damping="{c}">'
            f'<site site="{one}"/><site site="{two}"/></spatial>')


def rope(name, *stops):
    """Through sites, and around pulleys that are given as (pulley, a site on the side of the rope)."""
    inner = "".join(f'<site site="{stop}"/>' if isinstance(stop, str) else
                    f'<geom geom="{stop[0]}" sidesite="{stop[1]}"/>' for stop in stops)
    return f'<spatial name="{name}">{inner}</spatial>'


def combined(name, k=0, **factors):
    """Σ factor · joint, with a spring that is free as drawn."""
    inner = "".join(f'<joint joint="{joint}" coef="{factor}"/>' for joint, factor in factors.items())
    return f'<fixed name="{name}" stiffness="{k}" springlength="0">{inner}</fixed>'


def keep(tendon, other="", factor=0):
    """The change of one tendon's length is `factor` times that of the other."""
    second = f'tendon2="{other}" ' if other else ""
    return f'<tendon tendon1="{tendon}" {second}polycoef="0 {factor} 0 0 0"/>'


def geared(joint, other, ratio):
    """joint = ratio · other."""
    return f'<joint joint1="{joint}" joint2="{other}" polycoef="0 {ratio} 0 0 0"/>'


def joined(one, two):
    """Two sites stay together."""
    return f'<connect site1="{one}" site2="{two}"/>'


def added(*joints):
    """The row of an angle from a fixed direction, Σ joints."""
    return dict.fromkeys(joints, 1)


# the model in independent coordinates

class Machine:
    """A model. bodies, tendons, ties: its parts; rows: {coordinate: {joint: factor}} of those coordinates that are not
    joints; driven: {joint: its motion (s, ṡ, s̈)(t)}; loads: [(body, site, force in the fixed plane or (with follow) in
    the body, moment, follow)]."""

    def __init__(self, bodies, tendons=(), ties=(), g=0.0, rows=None, driven=None, loads=()):
        import mujoco

        self.mj = mujoco
        self.model = mujoco.MjModel.from_xml_string(
            f'<mujoco><compiler angle="radian"/><option gravity="0 {-g} 0" jacobian="dense"><flag contact="disable"/>'
            f'</option><worldbody>{"".join(bodies)}</worldbody><tendon>{"".join(tendons)}</tendon>'
            f'<equality>{"".join(ties)}</equality></mujoco>')
        self.data = mujoco.MjData(self.model)
        self.joints = [self.model.joint(i).name for i in range(self.model.njnt)]
        self.rows, self.driven, self.loads = rows or {}, driven or {}, loads

    def choose(self, names):
        """Take these coordinates as the independent ones."""
        self.names = list(names)
        self.S = np.array([self.row(name) for name in (*names, *self.driven)])
        rows = np.vstack([self._constraints(np.zeros(self.model.nv))[1], self.S])
        assert np.linalg.matrix_rank(rows, DEPENDENT * np.linalg.norm(rows, 2)) == self.model.nv, "q does not fix p"
        return self

    def row(self, name):
        factors = self.rows.get(name, {name: 1.0})
        assert set(factors) <= set(self.joints)
        return [factors.get(joint, 0.0) for joint in self.joints]

    def value(self, name, p):
        """The value of any coordinate at the joint positions p."""
        return float(np.dot(self.row(name), p))

    def _extended(self, parts, t):
        """The independent coordinates, their rates and accelerations, each with those of the driven joints."""
        motions = [motion(t) for motion in self.driven.values()]
        return [np.array([*part, *(motion[i] for motion in motions)]) for i, part in enumerate(parts)]

    def _place(self, p, held):
        """MuJoCo at rest in the position p, with (`held`) or without its constraints."""
        flag = int(self.mj.mjtDisableBit.mjDSBL_EQUALITY)
        self.model.opt.disableflags = self.model.opt.disableflags & ~flag | (0 if held else flag)
        self.data.qpos[:], self.data.qvel[:], self.data.qacc[:] = p, 0, 0
        self.mj.mj_fwdPosition(self.model, self.data)

    def _constraints(self, p):
        """G and J at p."""
        self._place(p, held=True)
        n = self.data.nefc
        return self.data.efc_pos[:n].copy(), self.data.efc_J[:n * self.model.nv].reshape(n, self.model.nv).copy()

    def _inverse(self, p):
        """G, and [J; S]⁻¹ in its columns of J and of S; redundant constraints do no harm."""
        G, J = self._constraints(p)
        found = np.linalg.pinv(np.vstack([J, self.S]), rcond=DEPENDENT)
        return G, found[:, :len(G)], found[:, len(G):]

    def position(self, q, t=0.0):
        """The joint positions p(q, t), by Newton's method from the drawn position on."""
        target, p = self._extended([q], t)[0], np.zeros(self.model.nv)
        for share in SHARES if self.model.neq else (1.0,):
            for _ in range(20):
                G, of_ties, of_rows = self._inverse(p)
                change = of_rows @ (share * target - self.S @ p) - of_ties @ G
                p = p + change
                if abs(change).max() <= CLOSED:
                    break
            assert abs(change).max() <= CLOSED, "the loops do not close"
        return p

    def residual(self, q, v, a, t=0.0):
        """The residual of the equation of motion of each coordinate, in the sense of M q̈ + … − Q."""
        p = self.position(q, t)
        _, rate, acceleration = self._extended([q, v, a], t)
        _, of_ties, of_rows = self._inverse(p)
        u = of_rows @ rate
        w = of_rows @ acceleration - of_ties @ (self._slope(p, u) @ u)
        B = of_rows[:, :len(self.names)]
        self._place(p, held=False)
        self.data.qvel[:], self.data.qacc[:] = u, w
        self.mj.mj_inverse(self.model, self.data)
        return B.T @ (self.data.qfrc_inverse - self._loads())

    def _slope(self, p, u):
        """dJ/dt along ṗ = u, by central differences."""
        if not self.model.neq:
            return self._constraints(p)[1]
        h = ALONG / max(abs(u).max(), 1e-9)
        return sum(weight / h * (self._constraints(p + i * h * u)[1] - self._constraints(p - i * h * u)[1])
                   for i, weight in STENCIL)

    def _loads(self):
        """The joint forces of the loads."""
        total = np.zeros(self.model.nv)
        for name, where, force, moment, follow in self.loads:
            carrier = self.data.body(name)
            force = carrier.xmat.reshape(3, 3) @ [*force, 0] if follow else np.array([*force, 0.0])
            place = self.data.site(where).xpos if where else carrier.xpos
            self.mj.mj_applyFT(self.model, self.data, force, np.array([0, 0, moment]), place, carrier.id, total)
        return total

    def mass_matrix(self, q, t=0.0):
        """Bᵀ M B at a position."""
        p = self.position(q, t)
        B = self._inverse(p)[2][:, :len(self.names)]
        self._place(p, held=False)
        found = np.zeros((len(B), len(B)))
        for column, result in zip(np.eye(len(B)), found, strict=True):
            self.mj.mj_mulM(self.model, self.data, result, column)
        return B.T @ found @ B

    def small_oscillations(self, q):
        """M, C (with gyroscopic terms) and K about a position of rest, by central differences of the residual."""
        rest, axes = np.zeros(len(q)), np.eye(len(q))

        def slope(function):
            return np.array([sum(weight / NEAR * (function(i * NEAR * axis) - function(-i * NEAR * axis))
                                 for i, weight in STENCIL) for axis in axes]).T

        C = slope(lambda change: self.residual(q, change, rest))
        K = slope(lambda change: self.residual(q + change, rest, rest))
        return self.mass_matrix(q), C, K
