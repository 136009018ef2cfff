"""Texts of the manual on what depends on time, and on long work. Data alone."""

TIME = [
    "`t` is the time, in seconds. A prescribed motion is the displacement from the drawn position as it stands, "
    "constants included: `Y*(1 - cos(w*t))` leaves that position at t = 0, and with `Y*cos(w*t)` the motion starts at "
    "Y. The time may stand in",
    [
        ("motions", "`pin: {at: O, by: Omega*t}`, `slide: Y*sin(Omega*t)`: a motion that is prescribed. Where all of "
         "it is, the body needs no mass."),
        ("points", "`S: {at: [0, 0], moves: [0, Y*sin(Omega*t)]}`: a support that is shaken"),
        ("forces", "`{at: block, force: F0*sin(Omega*t)}`, and any other load"),
        ("constraints", "`x2 = x1 + Y*sin(Omega*t)`, true as drawn, at t = 0"),
        ("energies", "`V: -F0*sin(Omega*t)*x`"),
        ("answers", "in energies and equations: `equation[x]: m*x'' + k*x = F0*sin(Omega*t)`"),
    ],
    "Pulses, waves and blows are made of",
    [
        ("step", "`F0*(step(t) - step(t - t1))`, a rectangular pulse; `H*sin(pi*t/T)*(step(t) - step(t - T))`, half a "
         "sine. What begins at t = 0 has not begun in the drawn position."),
        ("ramp", "`F0*(ramp(t) - ramp(t - t1))/t1` rises in t1 and stays"),
        ("impulse", "`P*impulse(t - t1)`, a blow of the momentum P"),
        ("square", "`F0*square(Omega*t)`; `F0*(1 + sawtooth(Omega*t))/2` rises from 0 to F0 in each period; "
         "`abs(sin(Omega*t))` and `max(0, sin(Omega*t))` are rectified waves"),
        ("records", "`m*ag(t - t0)`, a measured function: `vibcli explain record`"),
    ],
    "A driven displacement that stays bounded (waves, pulses, records, what decays) counts as a small motion of the "
    "springs, dampers and steady loads that it moves; `v*t` and `Omega*t` do not. Masses follow it as it stands, "
    "however small it is. One that jumps has impulses in its speed, and no acceleration there.",
    "Where all is prescribed, a linkage turned by its crank say, nothing is solved but its loops: `x(2 s)`, `x'(2 s)`, "
    "`T(2 s)`, reactions, and `crank.drive(2 s)`, the moment that it takes.",
    "The equations of motion hold it, those of small oscillations on their right-hand side. Equilibrium, frequencies, "
    "modes and damping are those of the scene without the terms that hold `t`, all small motions being held where they "
    "are drawn; centrifugal and gyroscopic terms of a "
    "steady rotation stay. Loads in time and driven displacements are small of the first order, as the coordinates "
    "are, and their products are left out: of a load that hangs on a curved path small oscillations keep F(t)·∂s/∂q at "
    "the equilibrium alone, of a spring that turns with its shaken end its stiffness there, and of a steady load whose "
    "`carrier` rocks by u(t) the load as drawn and what is linear in u. The report tells what that leaves out, "
    "F(t)·∂²s/∂q²·q or u(t)·∂K/∂u·q, where it is not zero; `motion: full` keeps it.",
    "Where inertia, damping or stiffness themselves change in time (a pendulum whose pivot is "
    "shaken upwards) there are no natural frequencies: `vibcli frequencies` says so; `vibcli equations` works, and so "
    "do motions in time with `motion: full`. So it is where inertia does it in the second order alone, as of pendulums "
    "that hang at a distance e below the axis of a cradle rocked by A·sin(Ωt), whose pivot also rises, by e·A²/2 at "
    "most: the first order of that motion is a pivot that `moves: [e*A*sin(Omega*t), 0]`.",
]

PATIENCE = [
    "Work of more than a second is told of on a terminal, with the time that is left at its own pace. It is given up "
    "beyond a limit, which counts steps and not seconds, so that every machine answers and refuses the same. What was "
    "found until then is kept. `--patience N` multiplies the limits by N:",
    [
        ("a full motion", "100000 steps, each a few oscillations of its fastest part. A fast oscillation of less than "
         "a millionth of the motion is stepped over where it would take 5000 more, and is part of the errors of what "
         "is printed. A motion that would need ten times as many steps as it may take is stopped after some thousand. "
         "Up to where it has come its values are known."),
        ("choose", "30000 steps, each a look at the conditions, or a step of what these need."),
        ("all equilibria", "10⁶/n² positions for n coordinates, at least 300 and at most 60000. Those found are "
         "listed, as a search that was cut short. The proof that there are no others looks at 50000 pieces of the "
         "bounds, of three coordinates at 20000. Without a proof the sum of the indices (signs of det K) is compared "
         "with the degree of the forces on the bounds, of 20000 pieces at most; where they differ, one more exists, "
         "and is looked for at 20000 positions more."),
        ("largest values, passages", "500000 steps of a search through a motion of small oscillations, each a "
         "thousand values of one of the exponentials that it is made of. What is found by then is told."),
        ("loads with jumps and bends", "100000 stretches of time from one jump or bend to the next."),
        ("motions under such loads", "20000 steps, each a thousand of these stretches of one of the exponentials."),
        ("peaks, curves of H", "10000 steps, each a million products."),
        ("modes", "10000 steps, each a million products of whole numbers, which some hundreds of coordinates with "
         "dampers need."),
        ("--digits, shares", "600 such steps, as estimated from the number of coordinates and digits alone, of a "
         "motion of small oscillations from its loads and instants too, of one of the full equations from its first "
         "steps; 200 for shares, sensitivities and estimates."),
    ],
    "Closed forms are given up after some millions of calls of functions within computer algebra, and N times as many "
    "with `--patience N`; that they were is said.",
]
