"""Mechanisms by Kane's method: the places, frames and loads of problem files, written out by hand for SymPy.

Each function of ALL is named after the problem that it describes. It gets a Model and p, the parameters as symbols, and
adds bodies and loads; vectors are places from the fixed origin. Coordinates mean what those of the file mean.
"""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia


class Model:
    """What goes into KanesMethod. `tied`: conditions of the dependent coordinates; `rolling`: those between velocities
    alone; g: gravity, None without it."""

    def __init__(self, g):
        self.N, self.O, self.t, self.g = ReferenceFrame("N"), Point("O"), dynamicsymbols._t, g
        self.O.set_vel(self.N, 0)
        self.independent, self.rolled, self.dependent = [], [], []
        self.bodies, self.loads, self.tied, self.rolling = [], [], [], []

    def coordinates(self, independent, dependent="", rolled=""):
        """Symbols of the coordinates: those free, those that `tied` gives, those whose rate `rolling` gives."""
        for kind, names in (("independent", independent), ("dependent", dependent), ("rolled", rolled)):
            setattr(self, kind, [dynamicsymbols(name) for name in names.split()])
        return self.independent + self.dependent + self.rolled

    def at(self, x, y):
        return x * self.N.x + y * self.N.y

    def turned(self, angle):
        """A frame turned by an angle, counter-clockwise."""
        return self.N.orientnew("A", "Axis", [angle, self.N.z])

    def point(self, place):
        point = self.O.locatenew("P", place)
        point.set_vel(self.N, place.dt(self.N))
        return point

    def particle(self, mass, place):
        point = self.point(place)
        self.bodies.append(Particle("particle", point, mass))
        self._weighed(point, mass)

    def body(self, mass, place, frame, J):
        """J: moment of inertia about the mass centre."""
        point = self.point(place)
        self.bodies.append(RigidBody("body", point, frame, mass, (inertia(frame, 0, 0, J), point)))
        self._weighed(point, mass)

    def rod(self, mass, length, foot, axis, frame):
        """A uniform rod from a place along a unit vector of its frame."""
        self.body(mass, foot + length / 2 * axis, frame, mass * length**2 / 12)

    def _weighed(self, point, mass):
        if self.g is not None:
            self.loads.append((point, -mass * self.g * self.N.y))

    def force(self, place, force):
        self.loads.append((self.point(place), force))

    def moment(self, frame, size):
        self.loads.append((frame, size * self.N.z))

    def pull(self, one, two, tension):
        """tension(length, rate): the tension of what joins two places."""
        reach = two - one
        length = reach.magnitude()
        size = tension(length, reach.dt(self.N).dot(reach) / length)
        self.force(one, size / length * reach)
        self.force(two, -size / length * reach)


def pendulum_on_sprung_cart(k, p):
    x, phi = k.coordinates("x phi")
    cart, A = k.at(x, 0), k.turned(phi)
    k.particle(p.M, cart)
    k.rod(p.m, p.L, cart, -A.y, A)
    k.pull(k.at(-p.L, 0), cart, lambda length, rate: p.k * (length - p.L) + p.c * rate)


def rod_hung_on_block_in_lift(k, p):
    y, phi = k.coordinates("y phi")
    A, block = k.turned(phi), k.at(0, p.a * k.t**2 / 2 + y)
    k.particle(p.m1, block)
    k.rod(p.m2, p.L, block, -A.y, A)
    k.force(block, -(p.k * y + p.c * y.diff(k.t)) * k.N.y)


def bead_on_swinging_rod(k, p):
    s, phi = k.coordinates("s phi")
    A = k.turned(phi)
    bead = -(p.a + s) * A.y
    k.rod(p.M, p.L, k.at(0, 0), -A.y, A)
    k.particle(p.m, bead)
    k.force(bead, p.k * s * A.y)


def disc_on_sprung_platform(k, p):
    x, s, theta = k.coordinates("x s", rolled="theta")
    platform, disc, B = k.at(x, 0), k.at(x + s, p.r), k.turned(theta)
    k.particle(p.m1, platform)
    k.body(p.m2, disc, B, p.m2 * p.r**2 / 2)
    k.force(platform, (p.k2 * s - p.k1 * x) * k.N.x)
    k.force(disc, -p.k2 * s * k.N.x)
    touching = disc.dt(k.N) + B.ang_vel_in(k.N).cross(-p.r * k.N.y)
    k.rolling = [(touching - platform.dt(k.N)).dot(k.N.x)]


def spool_on_driven_plank(k, p):
    s, theta = k.coordinates("s", rolled="theta")
    plank, B = p.Y * sin(p.Omega * k.t), k.turned(theta)
    spool = k.at(plank + s, p.R)
    k.body(p.m, spool, B, p.m * p.i**2)
    k.force(spool, -(p.k * (plank + s) + p.c * s.diff(k.t)) * k.N.x)
    touching = spool.dt(k.N) + B.ang_vel_in(k.N).cross(-p.R * k.N.y)
    k.rolling = [touching.dot(k.N.x) - plank.diff(k.t)]


def rods_on_shaken_pivot(k, p):
    alpha, beta = k.coordinates("alpha beta")
    A, B, pivot = k.turned(alpha), k.turned(beta), k.at(p.X * sin(p.Omega * k.t), 0)
    k.rod(p.m1, p.L1, pivot, -A.y, A)
    k.rod(p.m2, p.L2, pivot - p.L1 * A.y, -B.y, B)
    slip = alpha.diff(k.t) - beta.diff(k.t)
    k.moment(A, -p.ct * slip)
    k.moment(B, p.ct * slip)


def four_bar_with_springs(k, p):
    phi, psi, chi = k.coordinates("phi", "psi chi")
    crank, coupler, rocker = (k.turned(angle) for angle in (phi, psi, chi))
    A, along = p.a * crank.y, p.d * coupler.x + (p.c - p.a) * coupler.y
    C, E = k.at(p.d, 0), k.at(p.d + p.f, 0)
    B = C + p.c * rocker.y
    k.rod(p.mu * p.a, p.a, k.at(0, 0), crank.y, crank)
    k.body(p.mu * p.b, A + along / 2, coupler, p.mu * p.b**3 / 12)
    k.particle(p.m, A + along / 2)
    k.rod(p.mu * p.c, p.c, C, rocker.y, rocker)
    k.moment(crank, -p.kt * phi)
    k.pull(B, E, lambda length, rate: p.N + p.k * (length - sqrt(p.c**2 + p.f**2)))
    k.tied = [(A + along - B).dot(axis) for axis in (k.N.x, k.N.y)]


def slider_crank_on_spring(k, p):
    phi, psi, x = k.coordinates("phi", "psi x")
    crank, rod, slider = k.turned(phi), k.turned(psi), k.at(p.d + x, 0)
    A, along = p.r * crank.y, p.d * rod.x - p.r * rod.y
    k.rod(p.m1, p.r, k.at(0, 0), crank.y, crank)
    k.body(p.m2, A + along / 2, rod, p.m2 * p.l**2 / 12)
    k.particle(p.m3, slider)
    k.pull(slider, k.at(p.w, 0), lambda length, rate: p.k * (length - p.l0))
    k.tied = [(A + along - slider).dot(axis) for axis in (k.N.x, k.N.y)]


def hoist_with_moving_pulley(k, p):
    y, z, alpha, beta = k.coordinates("y", "z alpha beta")
    block, sheave = k.at(0, y), k.at(p.r1 + p.r2, p.H)
    k.body(p.m1, block, k.turned(alpha), p.m1 * p.r1**2 / 2)
    k.particle(p.m4, block)
    k.body(p.m2, sheave, k.turned(beta), p.m2 * p.r2**2 / 2)
    weight = k.at(p.r1 + 2 * p.r2, z)
    k.particle(p.m3, weight)
    k.force(weight, -p.k * z * k.N.y)
    k.tied = [2 * y + z, y - p.r1 * alpha, z - p.r2 * beta]     # the rope's length, its hold on block and sheave


def geared_pendulums(k, p):
    phi, psi, chi = k.coordinates("phi", "psi chi")
    one, two, three = (k.turned(angle) for angle in (phi, psi, chi))
    axle = k.at(p.r1 + p.r2, 0)
    k.body(0, k.at(0, 0), one, p.J1)
    k.rod(p.m1, p.L, k.at(0, 0), -one.y, one)
    k.body(0, axle, two, p.J2)
    k.particle(p.m2, axle - p.a * two.y)
    k.body(0, axle + p.c * k.N.y, three, p.J3)
    k.tied = [p.r1 * phi + p.r2 * psi, p.R2 * psi + p.R3 * chi]


def particle_on_turning_disc(k, p):
    u, v = k.coordinates("u v")
    D = k.turned(p.Omega * k.t)
    particle = u * D.x + v * D.y
    k.particle(p.m, particle)
    for peg in (p.a * D.x, p.a * D.y, -p.a * D.x, -p.a * D.y):
        k.pull(particle, peg, lambda length, rate: p.N + p.k * (length - p.a))


def bead_on_eccentric_hoop(k, p):
    s, = k.coordinates("s")
    H = k.turned(p.Omega * k.t)
    bead = (p.e + p.r * cos(s / p.r)) * H.x + p.r * sin(s / p.r) * H.y
    k.particle(p.m, bead)
    k.pull(k.at(0, 0), bead, lambda length, rate: p.k * (length - p.l0))


def bead_in_bowl_on_cart(k, p):
    x, u, height = k.coordinates("x u", "height")
    cart = k.at(x, 0)
    k.particle(p.M, cart)
    k.particle(p.m, cart + k.at(u, height))
    k.force(cart, -p.k * x * k.N.x)
    k.tied = [2 * p.p * height - u**2]


def column_under_follower_force(k, p):
    alpha, beta = k.coordinates("alpha beta")
    A, B = k.turned(alpha), k.turned(beta)
    knee = p.L * A.y
    tip = knee + p.L * B.y
    k.particle(2 * p.m, knee)
    k.particle(p.m, tip)
    k.moment(A, -p.k * alpha + p.k * (beta - alpha))
    k.moment(B, -p.k * (beta - alpha))
    k.force(tip, -p.P * B.y)


def lever_on_shaking_floor(k, p):
    phi, = k.coordinates("phi")
    A, floor = k.turned(phi), -p.h + p.Y * sin(p.Omega * k.t)
    k.rod(p.M, p.L, k.at(0, 0), A.x, A)
    k.particle(p.m, p.L * A.x)
    preload = -(p.M / 2 + p.m) * p.g * p.L / p.b
    k.pull(k.at(p.b, floor), p.b * A.x, lambda length, rate: preload + p.k * (length - p.h))
    k.pull(k.at(p.d, floor), p.d * A.x, lambda length, rate: p.c * rate)


def cam_and_follower_at_rest(k, p):
    phi, y = k.coordinates("phi", "y")
    cam, follower = k.turned(phi), k.at(0, p.h + y)
    centre = p.e * cam.x
    k.body(p.mc, centre, cam, p.J - p.mc * p.e**2)
    k.particle(p.m, follower)
    k.moment(cam, -p.kt * phi)
    k.force(follower, -(p.N + p.k * y + p.c * y.diff(k.t)) * k.N.y)
    k.tied = [(follower - centre).dot(follower - centre) - p.rho**2]


def epicyclic_gear_with_sprung_ring(k, p):
    theta, alpha, psi, rho = k.coordinates("theta alpha", "psi rho")
    arm, sun, planet, ring = (k.turned(angle) for angle in (theta, alpha, psi, rho))
    axle = -(p.rs + p.rp) * arm.y
    k.rod(p.ma, p.rs + p.rp, k.at(0, 0), -arm.y, arm)
    k.body(p.mp, axle, planet, p.mp * p.ip**2)
    k.particle(p.mb, axle - p.rp * planet.y)
    k.body(0, k.at(0, 0), sun, p.Js)
    k.body(0, k.at(0, 0), ring, p.Jr)
    k.moment(sun, -p.ks * alpha)
    k.moment(ring, -p.kr * rho)
    k.tied = [p.rs * (alpha - theta) + p.rp * (psi - theta), p.R * (rho - theta) - p.rp * (psi - theta)]


def trammel_with_particle(k, p):
    theta, x, y = k.coordinates("theta", "x y")
    A = k.turned(theta)
    middle = k.at(x - p.L / 2 * cos(p.theta0), y + p.L / 2 * sin(p.theta0))
    foot, head = middle - p.L / 2 * A.x, middle + p.L / 2 * A.x
    k.rod(p.m, p.L, foot, A.x, A)
    k.particle(p.M, foot + p.b * A.x)
    k.pull(foot, k.at(0, 0), lambda length, rate: p.k * (length - p.l0))
    k.tied = [foot.dot(k.N.y), head.dot(k.N.x)]


def galloping_sign_arm(k, p):
    phi, = k.coordinates("phi")
    A = k.turned(phi)
    k.rod(p.m, p.L, k.at(0, 0), A.x, A)
    k.particle(p.m0, p.L * A.x)
    k.moment(A, (p.m / 2 + p.m0) * p.g * p.L - p.kt * phi - p.ct * phi.diff(k.t))
    k.force(p.L * A.x, p.b * p.U * p.L * phi.diff(k.t) * cos(phi) * k.N.y)


def centrifugal_pendulum_absorber(k, p):
    theta, phi = k.coordinates("theta phi")
    disc, arm = k.turned(p.Omega * k.t + theta), k.turned(p.Omega * k.t + theta + phi)
    k.body(0, k.at(0, 0), disc, p.J)
    k.particle(p.m, p.R * disc.x + p.r * arm.x)
    k.moment(disc, p.M0 * sin(p.n * p.Omega * k.t))


def upright_rod_under_tension(k, p):
    phi, = k.coordinates("phi")
    A = k.turned(phi)
    k.rod(p.m, p.L, k.at(0, 0), A.y, A)
    k.pull(p.L * A.y, k.at(0, p.L + p.h), lambda length, rate: p.N + p.k * (length - p.h))


ALL = (pendulum_on_sprung_cart, rod_hung_on_block_in_lift, bead_on_swinging_rod, disc_on_sprung_platform,
       spool_on_driven_plank, rods_on_shaken_pivot, four_bar_with_springs, slider_crank_on_spring,
       hoist_with_moving_pulley, geared_pendulums, particle_on_turning_disc, bead_on_eccentric_hoop,
       bead_in_bowl_on_cart, column_under_follower_force, lever_on_shaking_floor, cam_and_follower_at_rest,
       epicyclic_gear_with_sprung_ring, trammel_with_particle, galloping_sign_arm, centrifugal_pendulum_absorber,
       upright_rod_under_tension)
