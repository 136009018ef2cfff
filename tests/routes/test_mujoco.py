"""Problem files against MuJoCo: its own geometry, mass matrices, ropes, tendons and constraints (support/mjcf.py).

Each function of MODELS builds the figure of the problem of the same name (a case: after two underscores) as MJCF from
the parameter values alone.
"""

import math
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from support.mjcf import (
    TINY,
    Machine,
    added,
    body,
    combined,
    disc,
    geared,
    hinge,
    joined,
    keep,
    mass,
    pulley,
    rod,
    rope,
    site,
    slide,
    spring,
)
from support.scenes import problem_of

from vibcli.check.instances import Instances
from vibcli.mechanics.lagrange import equation_of
from vibcli.results.random_states import at_states, states
from vibcli.symbolic.derivatives import gradient

pytest.importorskip("mujoco", reason="MuJoCo is not installed: pip install -e '.[test]'")

PROBLEMS = {path.stem: path for path in (Path(__file__).parents[2] / "problems").glob("*/*.yaml")}
EXACT, ROUNDING, FREQUENCY, ZERO, STATES = 1e-9, 1e-13, 1e-6, 1e-5, 3


# pendulums

def double_pendulum_rods(p):
    lower = body(0, -p.L1, hinge("bend"), rod(p.m2, 0, -p.L2))
    return Machine([body(0, 0, hinge("phi1"), rod(p.m1, 0, -p.L1), lower)], g=p.g,
                   rows={"phi2": added("phi1", "bend")})


def cart_with_pendulum(p):
    return Machine([body(0, 0, slide("x", 1, 0), mass(p.m1), body(0, 0, hinge("phi"), mass(p.m2, y=-p.L)))], g=p.g)


def cart_with_pendulum__tied(p):
    cart = body(0, 0, slide("x", 1, 0), mass(p.m1), site("cart"), body(0, 0, hinge("phi"), mass(p.m2, y=-p.L)))
    return Machine([site("wall", -p.w), cart], [spring("wall", "cart", p.k, p.w)], g=p.g)


def rods_on_shaken_pivot(p):
    """The pivot is a joint of the upper rod whose motion is prescribed."""
    lower = body(0, -p.L1, hinge("bend", c=p.ct), rod(p.m2, 0, -p.L2))
    return Machine([body(0, 0, slide("pivot", 1, 0), hinge("alpha"), rod(p.m1, 0, -p.L1), lower)], g=p.g,
                   rows={"beta": added("alpha", "bend")}, driven={"pivot": swing(p.X, p.Omega)})


def swing(size, rate):
    return lambda t: (size * math.sin(rate * t), size * rate * math.cos(rate * t), -size * rate**2 * math.sin(rate * t))


def bead_in_swinging_tube(p):
    """The inner spring carries the weight of the bead as drawn."""
    bead = body(0, -p.b, slide("s", 0, -1, k=p.k2, free=-p.m3 * p.g / p.k2), mass(p.m3))
    tube = body(0, 0, hinge("phi"), rod(p.m2, 0, -p.L), bead)
    return Machine([site("wall", -p.w), body(0, 0, slide("x", 1, 0), mass(p.m1), site("cart"), tube)],
                   [spring("wall", "cart", p.k1, p.w)], g=p.g)


def two_link_arm_under_load(p):
    second = body(p.L1, 0, hinge("bend", k=p.k2), rod(p.m2, p.L2, 0), site("tip", p.L2), name="second")
    return Machine([body(0, 0, hinge("alpha", k=p.k1), rod(p.m1, p.L1, 0), second, name="first")],
                   rows={"beta": added("alpha", "bend")},
                   loads=[("second", "tip", (p.Fx, p.Fy), 0, False), ("first", None, (0, 0), p.M0, False)])


def column_under_follower_force(p):
    upper = body(0, p.L, hinge("bend", k=p.k), mass(p.m, y=p.L), site("tip", 0, p.L), name="upper")
    return Machine([body(0, 0, hinge("alpha", k=p.k), mass(2 * p.m, y=p.L), upper)],
                   rows={"beta": added("alpha", "bend")}, loads=[("upper", "tip", (0, -p.P), 0, True)])


def column_under_follower_force__twice_the_force(p):
    return column_under_follower_force(p)


# springs and dampers between points

def rod_with_inclined_spring(p):
    return Machine([site("top", 0, p.h), body(0, 0, hinge("phi", k=p.kt), rod(p.m, p.L, 0), site("P", p.a))],
                   [spring("top", "P", p.k, p.l0)], g=p.g)


def disc_on_three_tight_springs(p):
    turns = [0, 2 * math.pi / 3, -2 * math.pi / 3]
    rim = [site(f"r{i}", p.R * math.cos(turn), p.R * math.sin(turn)) for i, turn in enumerate(turns)]
    pegs = [site(f"p{i}", (p.R + p.l) * math.cos(turn), (p.R + p.l) * math.sin(turn)) for i, turn in enumerate(turns)]
    plate = body(0, 0, slide("x", 1, 0), slide("y", 0, 1), hinge("phi"), disc(p.m, p.R), *rim)
    return Machine([*pegs, plate], [spring(f"r{i}", f"p{i}", p.k, p.l - p.N / p.k) for i in range(3)])


def quarter_car_damped(p):
    sprung = body(0, 1, slide("travel", 0, 1, k=p.ks, c=p.c), mass(p.ms))
    return Machine([body(0, 0, slide("x1", 0, 1, k=p.kt), mass(p.mu), sprung)], rows={"x2": added("x1", "travel")})


def overdamped_flap_gate(p):
    gate = body(0, 0, hinge("phi"), mass(p.m, p.m * (p.H**2 + p.t**2) / 12, y=-p.H / 2), site("lug", 0, -p.a))
    return Machine([site("bracket", p.d, -p.a - p.e), gate], [spring("lug", "bracket", c=p.c)], g=p.g)


def particle_on_turning_disc(p):
    """The inertia of the disc, whose turn is prescribed, plays no part."""
    pegs = [site(f"p{i}", p.a * x, p.a * y) for i, (x, y) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1)))]
    particle = body(0, 0, slide("u", 1, 0), slide("v", 0, 1), mass(p.m), site("particle"))
    return Machine([body(0, 0, hinge("turn"), mass(1, 1), *pegs, particle)],
                   [spring("particle", f"p{i}", p.k, p.a - p.N / p.k) for i in range(4)],
                   driven={"turn": lambda t: (p.Omega * t, p.Omega, 0.0)})


def bead_on_eccentric_hoop(p):
    ride = body(p.e, 0, hinge("ride"), mass(p.m, x=p.r), site("bead", p.r))
    return Machine([site("O"), body(0, 0, hinge("turn"), mass(1, 1), ride)], [spring("O", "bead", p.k, p.l0)],
                   rows={"s": {"ride": p.r}}, driven={"turn": lambda t: (p.Omega * t, p.Omega, 0.0)})


# ropes, gears and rolling

def hoist_with_moving_pulley(p):
    """One rope of constant length through the ceiling, around both wheels, to the counterweight."""
    wheel = body(0, 0, hinge("alpha"), disc(p.m1, p.r1))
    block = body(0, 0, slide("y", 0, 1), mass(p.m4), pulley("moving", p.r1), site("below", 0, -2 * p.r1), wheel)
    sheave = body(p.r1 + p.r2, p.H, hinge("beta"), disc(p.m2, p.r2))
    weight = body(p.r1 + 2 * p.r2, 0.8, slide("z", 0, 1), mass(p.m3), site("weight"))
    world = [site("ceiling", -p.r1, p.H), site("between", p.r1, p.H / 2), site("floor", p.r1 + 2 * p.r2, 0),
             pulley("fixed", p.r2, p.r1 + p.r2, p.H), site("above", p.r1 + p.r2, p.H + 2 * p.r2)]
    return Machine([*world, block, sheave, weight],
                   [rope("rope", "ceiling", ("moving", "below"), "between", ("fixed", "above"), "weight"),
                    spring("floor", "weight", p.k, 0.8)],
                   [keep("rope"), geared("y", "alpha", p.r1), geared("z", "beta", p.r2)], g=p.g)


def stepped_drum_with_block_and_pulley(p):
    """The length of each rope is that which the drum lets go or winds up."""
    wheel = body(0, 0, hinge("psi"), disc(p.mp, p.rho))
    moving = body(-p.R - p.rho, -0.8, slide("y", 0, 1), mass(TINY), pulley("moving", p.rho), site("axle"),
                  site("below", 0, -2 * p.rho), wheel)
    load = body(-p.R - p.rho, -1.4, slide("z", 0, 1), mass(p.m), site("load"))
    block = body(0.8 - p.r, 0.4, slide("s", -4, 3), mass(p.mb), site("block"))
    world = [site("ceiling", -p.R - 2 * p.rho, 1), site("rim", -p.R), site("peg", -p.r, 1),
             site("foot", 1.2 - p.r, 0.1)]
    return Machine([*world, body(0, 0, hinge("phi"), mass(1, p.J)), moving, load, block],
                   [rope("hoist", "ceiling", ("moving", "below"), "rim"), combined("let go", phi=p.R),
                    rope("haul", "peg", "block"), combined("wound up", phi=p.r),
                    spring("load", "axle", p.k1, 0.6), spring("foot", "block", p.k2, 0.5)],
                   [keep("hoist", "let go", 1), keep("haul", "wound up", -1), geared("y", "psi", p.rho)], g=p.g)


def geared_pendulums(p):
    first = body(0, 0, hinge("phi"), mass(1, p.J1), body(0, 0, rod(p.m1, 0, -p.L)))
    second = body(p.r1 + p.r2, 0, hinge("psi"), mass(1, p.J2), body(0, -p.a, mass(p.m2)))
    flywheel = body(p.r1 + p.r2, p.c, hinge("chi"), mass(1, p.J3))
    return Machine([first, second, flywheel], g=p.g,
                   ties=[geared("psi", "phi", -p.r1 / p.r2), geared("chi", "psi", -p.R2 / p.R3)])


def epicyclic_gear_with_sprung_ring(p):
    """All wheels ride on the arm, so that the gears are ordinary ones between the turns relative to it."""
    planet = body(0, -p.rs - p.rp, hinge("planet"), mass(p.mp, p.mp * p.ip**2), body(0, -p.rp, mass(p.mb)))
    wheels = [body(0, 0, hinge(name), mass(1, J)) for name, J in (("sun", p.Js), ("ring", p.Jr))]
    return Machine([body(0, 0, hinge("theta"), rod(p.ma, 0, -p.rs - p.rp), planet, *wheels)],
                   [combined("of sun", p.ks, theta=1, sun=1), combined("of ring", p.kr, theta=1, ring=1)],
                   [geared("sun", "planet", -p.rp / p.rs), geared("ring", "planet", p.rp / p.R)], g=p.g,
                   rows={name: added("theta", wheel) for name, wheel in
                         (("alpha", "sun"), ("psi", "planet"), ("rho", "ring"))})


def disc_on_seesaw(p):
    wheel = body(0, p.r, slide("s", 1, 0), hinge("spin"), disc(p.m, p.r), site("centre"))
    plank = body(0, 0, hinge("theta", k=p.kt), mass(p.M, p.M * p.L**2 / 12), site("post", -p.L / 2, p.r), wheel)
    return Machine([plank], [spring("post", "centre", p.k, p.L / 2)], [geared("spin", "s", -1 / p.r)], g=p.g)


def disc_on_seesaw__soft_torsion_spring(p):
    return disc_on_seesaw(p)


def disc_in_track_with_rod(p):
    """The line of centres turns about the centre of the track and carries the disc."""
    hanging = body(0, 0, hinge("bend"), rod(p.m2, 0, -p.L))
    wheel = body(0, 0, hinge("spin"), mass(TINY, p.m1 * p.r**2 / 2))
    return Machine([body(0, p.r - p.R, hinge("psi", y=p.R - p.r), mass(p.m1), wheel, hanging)],
                   ties=[geared("spin", "psi", -p.R / p.r)], g=p.g, rows={"phi": added("psi", "bend")})


# closed loops

def four_bar_with_springs(p):
    coupler = body(0, p.a, hinge("bend"), rod(p.mu * p.b, p.d, p.c - p.a), site("Bc", p.d, p.c - p.a),
                   body(p.d / 2, (p.c - p.a) / 2, mass(p.m)))
    return Machine([site("E", p.d + p.f), body(0, 0, hinge("phi", k=p.kt), rod(p.mu * p.a, 0, p.a), coupler),
                    body(p.d, 0, hinge("chi"), rod(p.mu * p.c, 0, p.c), site("B", 0, p.c))],
                   [spring("B", "E", p.k, math.hypot(p.c, p.f) - p.N / p.k)], [joined("B", "Bc")], g=p.g,
                   rows={"psi": added("phi", "bend")})


def slider_crank_on_spring(p, M0=0.0):
    link = body(0, p.r, hinge("bend"), rod(p.m2, p.d, -p.r), site("B", p.d, -p.r))
    return Machine([site("wall", p.w), body(0, 0, hinge("phi"), rod(p.m1, 0, p.r), link, name="crank"),
                    body(p.d, 0, slide("x", 1, 0), mass(p.m3), site("slider"))],
                   [spring("slider", "wall", p.k, p.l0)], [joined("B", "slider")], g=p.g,
                   rows={"psi": added("phi", "bend")}, loads=[("crank", None, (0, 0), M0, False)])


def slider_crank_on_spring__held(p):
    """The moment balances the drawn spring on the upright crank."""
    return slider_crank_on_spring(p, p.k * (p.w - p.d - p.l0) * p.r)


def scissor_lift_on_spring(p, load=0.0):
    """The second bar stands on a shoe; the right shoe of the table says no more and is left out."""
    third = body(-p.c, p.h, hinge("bend3"), rod(p.m, p.c, p.h), site("U3", p.c / 2, p.h / 2))
    fourth = body(p.c, p.h, hinge("bend4"), rod(p.m, -p.c, p.h), site("U4", -p.c / 2, p.h / 2), site("left", -p.c, p.h))
    first = body(0, 0, hinge("theta"), rod(p.m, p.c, p.h), site("middle1", p.c / 2, p.h / 2), fourth)
    second = body(p.c, 0, slide("foot", 1, 0), hinge("psi2"), rod(p.m, -p.c, p.h), site("S"),
                  site("middle2", -p.c / 2, p.h / 2), third)
    table = body(p.c / 2, 2 * p.h, slide("y", 0, 1), mass(p.M + load), site("hinge", -p.c / 2))
    N0 = (2 * p.M + 4 * p.m) * p.g * p.c / p.h
    return Machine([site("O"), first, second, table], [spring("O", "S", p.k, p.c - N0 / p.k)],
                   [joined("middle1", "middle2"), joined("U3", "U4"), joined("left", "hinge")], g=p.g,
                   rows={"psi4": added("theta", "bend4"), "psi3": added("psi2", "bend3")})


def scissor_lift_on_spring__loaded(p):
    return scissor_lift_on_spring(p, p.mc)


def platform_on_three_rods(p):
    """The spring is tightened so far that moving all lower ends by dφ (H, X) does no work."""
    N = (p.M + p.m1 + 3 * p.m / 2) * p.g * p.X / p.H
    ends = [0, p.a, p.a + p.b]
    rods = [body(x, 0, hinge(name), rod(p.m, p.X, -p.H), site(f"A{i}", p.X, -p.H))
            for i, (x, name) in enumerate(zip(ends, ("phi", "phi2", "phi3"), strict=True))]
    platform = body(p.X, -p.H, slide("x", 1, 0), slide("y", 0, 1), hinge("psi"), rod(p.M, ends[2], 0),
                    body(p.e, 0, mass(p.m1)), *(site(f"B{i}", x) for i, x in enumerate(ends)))
    return Machine([site("wall", p.X + ends[2] + p.w, -p.H), *rods, platform],
                   [spring("B2", "wall", p.k, p.w - N / p.k)], [joined(f"A{i}", f"B{i}") for i in range(3)], g=p.g)


def governor_linkage_at_rest(p):
    """The spring carries the sleeve, the links and the arms: 2 a sin α its way for a turn of the arms."""
    x, y = p.a * math.sin(p.alpha), p.a * math.cos(p.alpha)
    N = (p.m1 / 2 + p.m2 + 3 * p.m3 / 2 + p.m4) * p.g
    sides = [body(0, 0, hinge(arm), rod(p.m1, s * x, -y),
                  body(s * x, -y, mass(p.m2), body(0, 0, hinge(bend), rod(p.m3, -s * x, -y), site(bend, -s * x, -y))))
             for s, arm, bend in ((1, "phi", "right"), (-1, "chi", "left"))]
    sleeve = body(0, -2 * y, slide("y", 0, 1), mass(p.m4), site("sleeve"))
    return Machine([site("floor", 0, -2 * y - p.b), *sides, sleeve], [spring("floor", "sleeve", p.k, p.b + N / p.k)],
                   [joined("right", "sleeve"), joined("left", "sleeve")], g=p.g,
                   rows={"psi": added("phi", "right"), "eta": added("chi", "left")})


def cam_and_follower_at_rest(p):
    """A rope of constant length joins the centre of the disc and that of the roller."""
    cam = body(0, 0, hinge("phi", k=p.kt), mass(p.mc, p.J - p.mc * p.e**2, x=p.e), site("C", p.e))
    follower = body(0, p.h, slide("y", 0, 1), mass(p.m), site("roller"))
    return Machine([site("top", 0, p.h + p.b), cam, follower],
                   [rope("rho", "C", "roller"), spring("roller", "top", p.k, p.b + p.N / p.k, p.c)],
                   [keep("rho")], g=p.g)


def rod_in_bowl_with_end_masses(p):
    """Ropes of constant length from the centre of the bowl hold the ends."""
    bar = body(0, -p.d, slide("x", 1, 0), slide("y", 0, 1), hinge("phi"), mass(p.m, p.m * p.a**2 / 3),
               body(-p.a, 0, mass(p.m1), site("A")), body(p.a, 0, mass(p.m2), site("B")))
    return Machine([site("O"), bar], [rope("left", "O", "A"), rope("right", "O", "B")],
                   [keep("left"), keep("right")], g=p.g)


MODELS = [double_pendulum_rods, cart_with_pendulum, cart_with_pendulum__tied, rods_on_shaken_pivot,
          bead_in_swinging_tube, two_link_arm_under_load, column_under_follower_force,
          column_under_follower_force__twice_the_force, rod_with_inclined_spring, disc_on_three_tight_springs,
          quarter_car_damped, overdamped_flap_gate, particle_on_turning_disc, bead_on_eccentric_hoop,
          hoist_with_moving_pulley, stepped_drum_with_block_and_pulley, geared_pendulums,
          epicyclic_gear_with_sprung_ring, disc_on_seesaw, disc_on_seesaw__soft_torsion_spring, disc_in_track_with_rod,
          four_bar_with_springs, slider_crank_on_spring, slider_crank_on_spring__held, scissor_lift_on_spring,
          scissor_lift_on_spring__loaded, platform_on_three_rods, governor_linkage_at_rest, cam_and_follower_at_rest,
          rod_in_bowl_with_end_masses]


# what the equations do not depend on: lengths of the drawing, and what follows from other parameters or cancels
FREE_OF = {
    "cart_with_pendulum__tied": "w", "bead_in_swinging_tube": "w", "hoist_with_moving_pulley": "r1 r2 H",
    "stepped_drum_with_block_and_pulley": "rho", "geared_pendulums": "c", "slider_crank_on_spring": "l",
    "slider_crank_on_spring__held": "l M0", "scissor_lift_on_spring": "L mc N0",
    "scissor_lift_on_spring__loaded": "L N0", "platform_on_three_rods": "a b e",
    "governor_linkage_at_rest": "b g x1 y1", "cam_and_follower_at_rest": "rho b"}


class Compared:
    """A problem in numbers, random states of it in groups, and vibcli's left sides and mass matrices there."""

    def __init__(self, build):
        stem, _, case = build.__name__.partition("__")
        problem = problem_of(PROBLEMS[stem])
        self.build = build
        self.problem = next(iter(Instances(problem.case(case.replace("_", " ")) if case else problem)))
        scene = self.problem.scene
        self.names, n = scene.coordinates, len(scene.q)
        found, groups = states(self.problem)
        chosen = [i for group in groups for i in range(group.start, group.start + STATES)]
        self.groups = [slice(i, i + STATES) for i in range(0, len(chosen), STATES)]
        self.states = {name: values[chosen] for name, values in found.items()}
        left = [equation_of(scene, i) for i in range(n)]
        slopes = [gradient(node).get(a, scene.table.zero) for node in left for a in scene.a]
        self.left, self.M = self.values(left), self.values(slopes).reshape(-1, n, n)

    def values(self, nodes):
        """A row of the values of expressions for each state."""
        return np.array(at_states(self.problem, nodes, self.states)).T

    def machine(self, **wrong):
        """The model with the file's parameters, but for those that are given."""
        return self.build(SimpleNamespace(**self.problem.numeric.floats | wrong)).choose(self.names)

    def state(self, i):
        """(q, q', q'', t)."""
        parts = [np.array([self.states[name + "'" * primes][i] for name in self.names]) for primes in range(3)]
        return *parts, self.states[self.problem.scene.time.name][i] if self.problem.scene.timed else 0.0

    def equilibrium(self):
        return np.array([self.problem.configuration.equilibrium.values[name] for name in self.names])

    def agrees(self, machine, groups):
        """Do the left sides agree in each group, measured by their size there?"""
        size = abs(self.left).max(axis=0)
        for group in groups:
            ours = self.left[group]
            theirs = [machine.residual(*self.state(i)) for i in range(group.start, group.stop)]
            if (abs(theirs - ours).max(axis=0) > EXACT * abs(ours).max(axis=0) + ROUNDING * size).any():
                return False
        return True


@cache
def compared(build):
    return Compared(build)


@pytest.fixture(params=MODELS, ids=lambda build: build.__name__)
def both(request):
    return compared(request.param)


@pytest.mark.sweep
def test_equations_of_motion(both):
    assert both.agrees(both.machine(), both.groups)


def test_mass_matrix(both):
    machine = both.machine()
    for i, M in enumerate(both.M[both.groups[0]]):
        q, _, _, t = both.state(i)
        assert abs(machine.mass_matrix(q, t) - M).max() <= EXACT * abs(M).max()


def test_dependent_coordinates(both):
    machine, dependent = both.machine(), both.problem.scene.dependent
    values = both.values(dependent.values()) if dependent else []
    for i, found in enumerate(values):
        q, _, _, t = both.state(i)
        p = machine.position(q, t)
        assert [machine.value(name, p) for name in dependent] == pytest.approx(found, rel=EXACT, abs=EXACT)


def test_rest(both):
    """A step of Newton's method from the equilibrium leads nowhere."""
    q, zero = both.equilibrium(), np.zeros(len(both.names))
    machine = both.machine()
    _, _, K = machine.small_oscillations(q)
    step = np.linalg.pinv(K, rcond=EXACT) @ machine.residual(q, zero, zero)
    assert abs(step).max() <= EXACT


def test_frequencies_and_damping(both):
    M, C, K = both.machine().small_oscillations(both.equilibrium())
    modes, damped = both.problem.modal.modes, both.problem.modal.damped
    undamped = [complex(mode.growth_rate or 0, mode.omega or 0) for mode in modes]
    assert same_poles([w for z in undamped for w in (z, -z, z.conjugate(), -z.conjugate())],
                      poles(M, 0 * C if damped else C, K))
    if damped:
        found = [mode.eigenvalue for mode in damped]
        assert same_poles([w for z in found for w in (z, z.conjugate())], poles(M, C, K))


def poles(M, C, K):
    """The λ of (M λ² + C λ + K) q = 0."""
    ahead = np.eye(len(M))
    return np.linalg.eigvals(np.block([[0 * ahead, ahead], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]]))


def same_poles(expected, found):
    """Does each of either list lie next to one of the other; a double zero is found to the root of the rounding."""
    off = abs(np.subtract.outer(np.array(expected), found))
    near = FREQUENCY * abs(np.array(expected))[:, None] + ZERO * abs(found).max() * (np.array(expected) == 0)[:, None]
    return (off <= near).any(axis=0).all() and (off <= near).any(axis=1).all()


# wrong models

def test_a_wrong_number_is_detected(both):
    """One part in ten thousand of any parameter that the equations depend on."""
    unseen = [name for name, value in both.problem.numeric.floats.items()
              if both.agrees(both.machine(**{name: value * (1 + 1e-4)}), both.groups[:1])]
    assert sorted(unseen) == sorted(FREE_OF.get(both.build.__name__, "").split())


def test_a_wrong_figure_is_detected():
    """An angle relative to the upper rod; a hinge in its middle; a ring gear that meshes outside."""
    rods = compared(double_pendulum_rods)
    relative = rods.machine()
    relative.rows = {"phi2": {"bend": 1}}
    assert not rods.agrees(relative.choose(rods.names), rods.groups)
    p = SimpleNamespace(**rods.problem.numeric.floats)
    lower = body(0, -p.L1 / 2, hinge("bend"), rod(p.m2, 0, -p.L2))
    middle = Machine([body(0, 0, hinge("phi1"), rod(p.m1, 0, -p.L1), lower)], g=p.g,
                     rows={"phi2": added("phi1", "bend")})
    assert not rods.agrees(middle.choose(rods.names), rods.groups)
    gears = compared(epicyclic_gear_with_sprung_ring)
    assert not gears.agrees(gears.machine(R=-gears.problem.numeric.floats["R"]), gears.groups)


def test_wrong_poles_are_detected():
    assert same_poles([2j, -2j, 0], np.array([2j, -2j, 1e-8]))
    assert not same_poles([2j, -2j], np.array([2.00001j, -2.00001j]))
    assert not same_poles([2j, -2j], np.array([2j, -2j, 3j, -3j]))
    assert not same_poles([2j, -2j, 3j, -3j], np.array([2j, -2j]))
