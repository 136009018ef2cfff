"""Texts of the manual that no declaration holds: conventions, motions, exit codes. Data alone.

A topic is a list of parts: a text is a paragraph, a list of pairs a table. REMARKS are such parts for elements.
"""

from typing import Any

from vibcli.manual.bench import BENCH, STRESS
from vibcli.manual.ci import CI
from vibcli.manual.exports import EXPORTS
from vibcli.manual.expressions import EXPRESSIONS
from vibcli.manual.homework import GRADE, HOMEWORK, KNOWN_MISTAKES
from vibcli.manual.members import MEMBERS
from vibcli.manual.on_paper import DATA, PICTURES, REPORTS
from vibcli.manual.python import PYTHON
from vibcli.manual.responses import FREQUENCY_RESPONSE, PHASE_PLANE, RESPONSE, SIGNALS, STEPS, SWEEP
from vibcli.manual.time_and_work import PATIENCE, TIME
from vibcli.report.formats import FORMATS

EXIT_CODES = [
    ("0", "all well"),
    ("1", "an answer differs (`vibcli check`)"),
    ("2", "the command line is wrong"),
    ("3", "a file is invalid: the diagnostics name line and column"),
    ("4", "a scene cannot be solved, for a physical cause that is named; whether an answer agrees is uncertain "
          "(`vibcli check`); or what was found cannot be written"),
    ("5", "nothing was found to check"),
    ("101", "an error of vibcli itself"),
    ("130", "interrupted, or told to end"),
]

COMPARED = [
    ("numbers", "A written number allows half a unit of its last digit, never more than 0.5 %; one of fewer "
     "than three digits is exact. `{value: 21.9 rad/s, rtol: 0.5 %}` sets the tolerance."),
    ("expressions", "To rounding (1e-9): `omega[1]: sqrt(k/m)`. Both sides may hold parameters and quantities: "
     "`omega[2]/omega[1]: sqrt(3)`."),
    ("uncertain", "Where the error bound of the result reaches across an edge of the tolerance, the result is found "
     "anew to more digits. Where that does not settle it, as in motions with dry friction, the answer is uncertain "
     "(exit code 4), never right: write fewer digits, or give `rtol`."),
    ("equations", "Up to a non-zero factor, at random states of motion. `equation[q]` is that of small "
     "oscillations, q counted from the equilibrium; `motion[q]` is the full one, q counted as in the scene."),
    ("energies", "`T` and `Phi` at random states, `V` up to a constant; `T` and `V` with or without their terms of the "
     "time alone."),
    ("symbols", "A scene with symbols is compared at several sets of random values for them."),
    ("stable", "`true` or `false`."),
]

SEVERAL = ("A last index of its own asks about one of all the equilibria that `find: {equilibria: all}` lists, in "
           "ascending order: `equilibrium[phi][2]`, `stable[2]`, `omega[1][2]`, `K[x,y][2]`; likewise ")

IN_SHORT = ("A written number to half a unit of its last digit (or as `rtol` says), an expression to rounding: see "
            "`vibcli explain quantities`.")

CONVENTIONS = [
    [
        ("axes", "x to the right, y up; angles and moments counter-clockwise. Everything is drawn in one fixed frame, "
         "in the position that the figure shows."),
        ("coordinates", "Zero as drawn, unless `coordinates` says `drawn`. A motion is the change of its expression "
         "since the drawn position, so constants in it do not matter; what is prescribed in time counts as it stands "
         "(`vibcli explain time`)."),
        ("carriers", "`carrier` makes a motion relative to another body, and its directions turn with it. The "
         "angle of a pin is that in the fixed frame unless `relative: true`; so is the `turn` of a rolling body."),
        ("springs", "Stretch, tension and preload are positive in lengthening. A spring is undeformed as drawn "
         "unless `free_length` or `preload` says otherwise. Between bodies without a place it stretches by the "
         "motion of the second end minus that of the first."),
        ("loads", "Forces act in the fixed frame, unless a `carrier` turns them; moments counter-clockwise. A rotating "
         "unbalance acts along (cos(Omega*t), sin(Omega*t)), on a body without a place along its axis by "
         "sin(Omega*t)."),
        ("constraints", "They hold as drawn, and make later coordinates depend on earlier ones. Forces of ropes and "
         "links are positive in tension."),
        ("gravity", "`g` acts along −y, or as the vector given; without the section nothing has weight."),
        ("equilibrium", "The drawn position where that is one, else the one that is reached from there downhill; where "
         "`equilibrium` names a place, the nearest one to it, stable or not. "
         "Frequencies are those of small oscillations about it. What depends on the time is left out of both."),
        ("omega, f, T", "omega is the angular frequency in rad/s, f = omega/(2 pi) the frequency in Hz, T = 1/f the "
         "period. They belong to the system without its dampers; gyroscopic terms stay."),
        ("modes", "Numbered from 1 by ascending omega². Unstable modes come first (a growth rate instead of omega, "
         "in flutter besides it), then rigid ones (omega = 0 exactly)."),
        ("mode shapes", "Normalised so that the first coordinate that moves is 1; `--normalise largest` or `mass` "
         "(shapeᵀ M shape = 1) on the command line. A shape of a damped mode is complex: its argument is the phase "
         "by which a coordinate leads the first one."),
        ("damping", "x ~ exp(λt) with λ = −δ ± i omega_d: omega = |λ|, zeta = −Re λ/|λ|, δ = −Re λ = zeta·omega is "
         "the decay, omega_d = omega·√(1 − zeta²). The logarithmic decrement is 2 pi zeta/√(1 − zeta²). Damped "
         "modes are numbered by ascending |λ|. Two real eigenvalues of an over-damped mode share its number: "
         "omega = √(λ₁λ₂), zeta = −(λ₁ + λ₂)/(2 omega) ≥ 1, and the decay is zeta·omega; `eigenvalue[1]` is that which "
         "decays more slowly."),
        ("time", "Motions start at t = 0; that is also the t of loads and driven motions."),
        ("free", "A free vibration of one frequency is A e^(−δt) cos(omega_d t − φ): `amplitude(x)` is A, `phase(x)` "
         "is φ."),
        ("steady", "A steady state of one frequency is X sin(Omega t − θ): `amplitude(x)` is X, from the mean to the "
         "peak, `phase(x)` is θ, from −pi to pi, whatever phase the load has. `--phase cosine` prints θ of "
         "X cos(Omega t − θ), `--phase lead` α of X sin(Omega t + α)."),
        ("lag", "The phase of a frequency response is the lag of the signal behind the input, `phase` = −`arg`."),
        ("units", "Any of the list in, SI out; angles in radians."),
    ],
]

GROUND = [
    "`ground` is an end of a spring or damper: the fixed world, for bodies without a place and for torsion. A "
    "spring of a body that has a place ends at a place on the ground, `[x, y]`, because its direction matters.",
    [
        ("lumped", "`between: [ground, block]` stretches by the displacement of `block`."),
        ("torsion", "`between: [ground, rod]` twists by the angle of `rod`."),
    ],
    "No point or body can be called ground.",
]

LUMPED = [
    "A body without a place (no `at`, `from`, `parts`) is lumped: it lies on one axis, of which nothing needs to be "
    "drawn. It has one motion and no weight.",
    [
        ("block: {mass: m, slide: x}", "translates by x; springs and dampers act along the axis."),
        ("disc: {inertia: J, turn: phi}", "turns by phi; torsion springs and dampers act on it."),
        ("trolley: {mass: m, slide: {by: u, carrier: car}}", "u is measured from the car, which has no place either; "
         "so is psi of `turn: {by: psi, carrier: motor}` from the motor."),
    ],
    "Its motion may be an expression, which states a gear, a rope or a rack: `slide: r*phi`, `turn: -z1/z2*phi`. "
    "Lumped bodies are joined with one another and with `ground`.",
]

CASES = [
    "Each case is a part of a scene, merged over the scene: mappings are merged key by key, anything else is "
    "replaced. `answers` and `find` are the case's own. A case may add parameters, bodies and springs, and it "
    "cannot hold cases itself. A parameter that the scene chooses and the case gives a value is not chosen there. "
    "`vibcli solve FILE --case NAME` solves one alone.",
]

MOTIONS = [
    "How a body may move is one key of it; without any it is fixed. Each displacement and angle is a coordinate or "
    "an expression of coordinates and the time: `slide: x`, `pin: {at: O, by: 2*phi}`, `pin: Omega*t`. A name that "
    "stands alone and is no parameter becomes a coordinate; one within an expression is declared first: "
    "`coordinates: [psi]` for `pin: Omega*t + psi`.",
    "What ties several motions together stands under `constraints`, unless one is simply given by another: "
    "`turn: -x/R`.",
]

STATICS = [
    "Where supports and constraints leave no freedom, as in beams, three-hinged frames and brackets with ropes, "
    "`vibcli solve` prints the conditions of equilibrium and the forces of all supports, joints, links and ropes, in "
    "letters or numbers. Beams lie on `pin: {at: A, by: phi}` and `roller: {point: B, surface: floor}`, are joined by "
    "`join`, held by `link` or `rope`, or stand in a `clamp`; each turn that is held still has its name.",
    [
        ("equilibrium[A.reaction.y]", "force of the support at a point A, `A.reaction.moment` of a clamp"),
        ("equilibrium[roller.force]", "force of a constraint; `knee.force.x` of a joint on its second point"),
    ],
    "What more supports hold than are needed shares its load in a proportion that rigid bodies do not fix: such "
    "forces are told by name and have no value.",
    "Where nothing holds a scene no equilibrium is needed: `find: [accelerations]` finds the accelerations from rest "
    "in the drawn position and the forces then, `x''(0 s)` and `rope.force(0 s)` ask for them in `answers`, and the "
    "motion in time is that of the full equations, from rest as drawn unless `initial` says otherwise.",
]

SHAPES = [
    "Uniform plane bodies. C is the mass centre; O, of a sector or arch, the centre of its circle, where `at` "
    "stands, and OC points along `angle`. m is the mass: `mass`, or `density` times area or length. "
    "`inertia` or `gyration` override the moment of inertia.",
    "A body rolls, meshes and carries ropes about the centre of its circle: that of its shape, of its round parts, or "
    "of a body that is not round its pin, if it has one. Everywhere else its name stands for its mass centre: for "
    "springs, dampers, forces, links and signals, and where `slide` and `move` say how far.",
]

REMARKS: dict[str, Any] = {
    "constraint": [
        "Each holds as drawn, and each of its conditions makes one coordinate depend on the others: a later one, as "
        "far as there is a choice, in the order of `coordinates`, or else of the file. A constraint that follows from "
        "the others is allowed and told; one that contradicts them is an error. Where they leave nothing that moves "
        "the scene is one of statics: `vibcli explain statics`.",
        [
            ("x2 = 2*x1", "an equation between coordinates, which may hold the time"),
            ("{rope: [A, {over: wheel}, B]}", "a rope of constant length: see `vibcli explain pulley`"),
            ("{gear: [a, b], radii: [r1, r2]}", "wheels that mesh and turn against each other, with `inside: true` in "
             "one sense; `carrier: arm` where an arm carries their axes (planetary gears)"),
            ("{belt: [a, b], radii: [r1, r2]}", "pulleys that turn in one sense, with `crossed: true` against each "
             "other"),
            ("{join: [P, Q]}", "two points pinned together: closes a loop"),
            ("{link: [P, Q]}", "two points at a constant distance"),
            ("{point: P, surface: track}", "a point on a line, circle or curve"),
        ],
        "Where a loop closes only by solving equations (linkages), the full equations keep all coordinates, with a "
        "multiplier λ for each condition; equilibrium, small oscillations and frequencies are found in the independent "
        "ones, and `equilibrium[q]` gives the dependent ones too.",
    ],
    "pulley of a rope": [
        "The side is that where the rope touches: the upper one (+y) for `over`, the lower one for `under`, the one at "
        "−x for `left_of` and at +x for `right_of`. The first or last stop may be a drum that the rope is wound on: "
        "`{rope: [{right_of: drum}, load]}`.",
        "On a body that turns the rope does not slip; round a place, or a body that does not turn, it slides freely. "
        "Ropes are taken to be taut: one that would have to push in equilibrium is told.",
    ],
    "force": [
        "Components are along the fixed axes; with `carrier` they turn with that body, from the drawn position on.",
        "Loads with the time `t` drive the scene and leave its equilibrium alone; constant ones, and those of "
        "coordinates, shift it. Each summand is one or the other, as it is written: of `F0 + F1*sin(W*t)` the first "
        "is constant, `F0*(1 - cos(W*t))` is in time as a whole. A load of velocities damps: `value: -c*x'`.",
    ],
    "record": [
        "The file is plain text of at most 100 MB and 2000000 rows, in UTF-8, with decimal points. Names lead down "
        "from the folder of the scene, never out of it. Its numbers are read as double precision. What is measured in "
        "units of g has no unit: write `g*ag(t)`.",
        "Responses of small motions are exact for the straight lines between the samples. The rate of a record is a "
        "staircase, and its second rate, where something is carried by what moves so, holds an impulse at each sample. "
        "Small motions follow up to 4000000 samples, however many loads share them; where a record is multiplied by "
        "what changes in time or drives members, and full motions, 100000.",
    ],
    "point": ["A driven point is one that bodies can be pinned at, and springs, ropes and links can end at."],
}

EDITORS = [
    "`vibcli schema` prints the JSON Schema (draft 7) of scene files, from the same declarations as this manual and "
    "the error messages. An editor that knows it completes keys and underlines slips:",
    [
        ("vibcli schema > scene.schema.json", ""),
        ("# yaml-language-server: $schema=scene.schema.json", "as the first line of a scene"),
    ],
    "Dimensions, names and geometry are checked by vibcli alone: `vibcli check FILE`.",
]

TOPICS: dict[str, Any] = {
    "expressions": ("how numbers, units, names and derivatives are written", EXPRESSIONS),
    "units": ("the units that are known", None),
    "functions": ("the functions that are known", None),
    "conventions": ("signs, coordinates, numbering of modes, damping, amplitudes and phases", CONVENTIONS),
    "motions": ("how bodies may move", MOTIONS),
    "statics": ("scenes without freedom, and scenes that nothing holds", STATICS),
    "shapes": ("the shapes of bodies, with their moments of inertia", SHAPES),
    "members": ("bars, shafts, beams and strings with their mass", MEMBERS),
    "lumped": ("bodies without a place", LUMPED),
    "time": ("driven motion, loads that depend on time, and what becomes of them", TIME),
    "response": ("motions in time", RESPONSE),
    "phase_plane": ("orbits of one degree of freedom over its place and speed", PHASE_PLANE),
    "steps": ("the worked solution, line by line", STEPS),
    "sweep": ("quantities over one or two parameters", SWEEP),
    "mistakes": ("known mistakes, and how they are found", KNOWN_MISTAKES),
    "homework": ("variants of a problem, and the gates that they pass", HOMEWORK),
    "grade": ("answers that come back, marked by the manifest of the sheets", GRADE),
    "exports": ("packages of variants for course systems: Moodle, PrairieLearn, QTI, Canvas", EXPORTS),
    "frequency_response": ("amplitude and phase over the frequency", FREQUENCY_RESPONSE),
    "signals": ("places, turns, stretches and forces that can be asked for", SIGNALS),
    "ground": ("the fixed end of springs and dampers", GROUND),
    "quantities": ("what `answers` may ask for, and how it is compared", None),
    "exit": ("exit codes", None),
    "ci": ("problem sets that a server checks: forms of the report, rules, what is kept", CI),
    "bench": ("run time against true error, beside other methods", BENCH),
    "stress": ("families of scenes that one knob makes ever harder: true errors beside bounds", STRESS),
    "patience": ("long work: what is told of it, and where it is given up", PATIENCE),
    "pictures": ("figures of scenes, moving modes, plots of responses", PICTURES),
    "reports": (", ".join(FORMATS), REPORTS),
    "data": ("responses as numbers for other programs", DATA),
    "json": ("the keys of --json", None),
    "python": ("scenes in Python: `import vibcli`", PYTHON),
    "editors": ("completion and checking in an editor", EDITORS),
}
