"""Texts of the manual on motions in time, frequency responses and signals. Data alone."""

from vibcli.language import member_signals, signals

RESPONSE = [
    "`vibcli response FILE` finds the motion in time, and so do `find: [response]` and every quantity of a signal in "
    "`answers`. It needs numbers for all parameters; in letters it tells steady states of one harmonic or behind "
    "powers of the time, and of one degree of freedom the motion from the start.",
    [
        ("start", "At t = 0, as `initial` says: `{x: 2 cm, x': 0.5 m/s}`, counted as in the drawn position. A "
         "coordinate left out starts where the equilibrium has it, or as drawn where nothing holds the scene; a "
         "velocity left out is 0. `{released: pull}` starts "
         "at rest in the equilibrium under the steady force `pull`, which lets go at t = 0. Loads that depend on the "
         "time are not there before t = 0. A coordinate without inertia takes no velocity, and a place only where a "
         "damper holds it back: relaxation, or Zener's model with a joint between a spring and a damper. Other ones "
         "follow at once. `motion: full` needs an inertia for each."),
        ("small", "`motion: small`, the default where there is an equilibrium: small oscillations about it, exact at "
         "any time."),
        ("waves", "Bars, shafts and strings without drag and foundation, whose tension does not vary along them, are "
         "followed by travelling waves, exact but for rounding: f(t − x/c) + g(t + x/c) between what stands on them. "
         "Fronts stay sharp: at a front values in time are those after it, `--at` tells both, `max` and `min` look at "
         "both, files and plots hold the instant twice. Members start with fields, `initial: {rod.u: a*x/L, rod.u': "
         "-v}`. Loads along them travel with the waves. Where the fronts multiply, as on pieces of many lengths or "
         "under long records, values at instants "
         "follow them as long as they stay few, and all else goes by modes; `--patience` follows more."),
        ("parts", "Parts of a scene that do not move one another go each their own way: a straight beam that stretches "
         "does so by waves, and bends by modes, as long as fronts are few up to the end that is asked for."),
        ("modes", "Beams, and members with foundation or drag, are followed "
         "by their first exact modes beside what loads do exactly: what is left out are free vibrations of higher "
         "modes, at most 2048 of a uniform beam being counted. Their bound is part of the error of each value: 1e-10 "
         "of the largest displacement of a beam where it is cheap, far more of moments, most of shears. These have no "
         "bound after a blow, or where a force sets in or lets go at once at a place without mass: waves run along a "
         "beam the faster the shorter they are, and at some instants so many meet that a shear there is infinite. They "
         "have one where loads rise within a time, are spread along the beam, or act on a mass, and after a while "
         "where `damping:` damps all modes evenly. For "
         "bars, shafts and strings with drag and foundation in proportion to their mass, beside which nothing has mass "
         "or dampers, values at instants, and forces for which modes know no bound, are integrals over the waves "
         "without both instead, exact but for rounding, as long as fronts stay few."),
        ("damped modes", "Where dampers, or drag that differs by mass from place to place, couple the modes of "
         "members, the same sum runs over damped modes, each with its own complex frequency, as many of them as the "
         "argument principle counts in a circle; of those that are one or nearly so, as at critical damping, the "
         "mean over a circle about them. What those left out add to displacements and slopes, and to rates of what "
         "has mass, is bounded by the energy that each jump or bend of loads at places and along members, each bend of "
         "the way of a driven end, each blow on a mass or along a member, or the start leaves them, which never grows, "
         "and which fades where drag acts on all that has mass. Of moments, forces and other rates the energy of their "
         "rate does it, where loads begin smoothly, set in on a mass or along members. After a force sets in at once "
         "where nothing has mass, moments of beams and rates of their displacements have a bound too, and after a blow "
         "there their displacements, by energies of what is smoothed ever less, whose sum converges; after a start in "
         "fields that fit all ends and joints, moments, forces and rates. Else, as of a shear after a force that sets "
         "in at once there, with driven ends that jump, of moments after a start in a field that bends a free end, or "
         "where loads along a chain or mast are no polynomials of the place, it is estimated from how amplitudes fall; "
         "reports, `check` and `--json` say so, reports why: of a start, driven ends and other loads each that would "
         "leave no bound by itself. A damper of √(Nμ) beside drag is "
         "refused, as no wave comes back from it."),
        ("coupled modes", "Where dampers couple the modes that `damping:` damps, the sum runs over what the first "
         "modes do together, behind which for each damper one shape follows it as all others do at rest. Of "
         "displacements and slopes after steps, ramps, blows on masses and slow oscillations, or a start, what it "
         "leaves is bounded: the error has no more energy than what the others begin with and what dampers would take "
         "of the forces left out, and what is read of it is as small once more (reciprocity). Of moments, forces and "
         "rates, of `caughey` through more than two modes, of what nothing holds and of other loads it is estimated, "
         "by half as many modes too."),
        ("not known", "A number whose error has a bound, certain or estimated, as large as all that its signal becomes "
         "is not told: reports say `not known` and why, `--json` gives null and the reason, files leave such samples "
         "blank, and `check` finds no answer. A value next to a passage through zero is told, and so is what stays at "
         "zero while others of its kind move."),
        ("full", "`motion: full`: the full equations, integrated, for wide swings, laws, dry friction, stops, slack. "
         "Events and the balance of the energies are printed; a motion whose energies do not balance to 1e-8, or to "
         "the accuracy that is asked, is refused. It is found twice, by rules of another order or by longer steps, and "
         "with another last digit of its start: what the two do not share is not printed, and from where they share "
         "less than three digits (chaos, a start at an unstable place) nothing is known; plots and files end there. "
         "Values in time, `max`, `min`, `zero` and `period` can be asked, no steady states. What starts at rest in its "
         "equilibrium stays there, to the last digit, until a load or a drive in time acts. A period is looked for "
         "beyond the end, up to eight times as long."),
        ("accuracy", "`motion: {accuracy: 1e-6}` or `--accuracy 1e-6` asks how accurately the full equations are "
         "integrated: from 1e-13 to 1e-3 of each coordinate and velocity, relative to how far it goes, or to its "
         "largest value where that is less; what hardly moves is held to a thousandth of where it is, or of what moves "
         "most beside it. Unless asked 1e-9 is aimed at. The errors that are printed are estimated all the same: where "
         "they exceed what is asked, steps are tightened, and where that does not help, the motion ends and says so. "
         "Less is sooner found: long motions of few coordinates without loops, friction, stops and pulses are guessed "
         "by explicit steps and refined in many windows at once, which are as much longer as less is asked; all others "
         "go by collocation from one window to the next, which takes as long whatever is asked. Where heyoka is "
         "installed (`pip install 'vibcli[heyoka]'`), motions of that kind that are so long that compiling pays, as "
         "some hundred swings of a double pendulum, go by compiled Taylor series, to all digits of floats; without it "
         "the same motions take longer."),
        ("full --digits", "With `--digits N` the full equations are followed by power series, twice, with as many "
         "digits more as neighbouring motions lose, until both agree to N digits: chaos has no horizon then. Steps and "
         "bends of the time are ends of pieces. What bends or jumps with the motion (friction, stops, ropes, "
         "abs(x')), impulses and records are refused."),
        ("end", "`find: {response: {until: 2 s}}`, or `--until`. Unless given: until what decays slowest has fallen to "
         "1/1000, between 2 and 60 of the longest periods; where something grows, until it is 1000 times as large, at "
         "most 10 periods; without either 10 periods, or two beats if that is more, at most 60 periods. That is "
         "counted from where the loads last change their form; where nothing vibrates nor decays, as long again. "
         "Periods are those of the modes that are shown and of the loads; loads that die out are followed until they "
         "have fallen to 1/1000. With `motion: full` periods are those of the modes alone, and loads are "
         "followed for two of their longest periods where nothing grows; what takes 200 times as long as without loads "
         "is refused."),
        ("digits", "Every value of a small motion has a bound of its error, and only digits that this supports are "
         "printed. Where the bound exceeds 1e-9 of the largest value up to there, as after millions of cycles, the "
         "value, extreme, zero or number of the steady state is found anew from the exact data, to 25 digits, if that "
         "takes a second or so; curves, plots and files carry floats. `--digits 30` gives values and extremes to 30 "
         "digits."),
        ("extremes", "`max`, `min`, `argmax`, `argmin` and `zero[i]` look at 0 ≤ t ≤ end. A touch of "
         "zero counts as a passage does."),
        ("steady", "What is left when the free vibration has died out; `transient` is the rest. Without damping the "
         "steady state is the motion with the frequencies of the loads alone, and the rest does not die out. At a "
         "resonance without damping there is none. Of members under loads with harmonics without end it is found where "
         "they are damped, and of bars, shafts and strings whose free vibrations repeat themselves after a time "
         "commensurate with the period of the loads. Of a ramp or another power of the time it is what follows it, "
         "v t − c v/k."),
        ("formula", "Printed where it is short: decaying vibrations and waves, for each piece of the loads."),
    ],
    "What `answers` and `choose` may ask of a signal, such as `x`, `x'`, `P.y`, `s.force` or `s.force + d.force`:",
    [
        ("x(0.4 s)", "its value; `x'(0.4 s)` that of its rate; of a sum "
         "`(s.force + d.force)(0.4 s)`; at a jump the value after it. `--at 0.4` prints "
         "it, `--digits 30` to 30 digits"),
        ("max(x)", "likewise `min`, `argmax`, `argmin`, `zero[1]`"),
        ("final(x)", "its limit, of members where it is seen to come to rest; of a difference that has one too, as of "
         "the lag behind a ramp `final(base.x - x)`; `overshoot(x)` is (max − final)/(final − start)"),
        ("amplitude(x)", "with `phase(x)`, `period(x)`: of the steady state, or where no load oscillates without end "
         "of the free vibration; of members where all repeats itself, as in a bar without masses that nothing damps"),
        ("mean(x)", "with `rms(x)`: of the steady state, or of free vibrations that do not die out, of members too. Of "
         "powers and products: `mean(x^2)`, `mean(P.power)` of a load, `mean(d.power)` of a damper, "
         "`mean(s.force*x')`, exactly, and over all times where the frequencies have no common period; of other "
         "functions, `mean(abs(x))`, over the common period by quadrature"),
        ("harmonic[3](x)", "amplitude of a harmonic of a periodic steady state"),
        ("decrement(x)", "with `time_to[0.1](x)`, `cycles_to[0.1](x)`: of a free vibration of one frequency, after the "
         "last change of the loads; of what a load keeps up ask for `decrement(transient(x))`"),
        ("beat_period(x)", "of two neighbouring frequencies"),
        ("envelope(x)", "a signal, `envelope(x)(2 s)`, `max(envelope(x))`: of exactly one vibration A e^(−δt), of "
         "exactly two, each free or kept up by a load, √(A₁² + A₂² + 2A₁A₂ cos(Δω t − Δφ)), each A with its own decay: "
         "beats where the frequencies are near. What does not vibrate is left out. Of more vibrations there is none, "
         "nor at a resonance without damping, nor of loads that change after t = 0 or have harmonics without end"),
        ("steady(x)", "with `transient(x)`: signals again, as in `max(steady(x))`, `steady(x)(2 s)`"),
    ],
    "Loads in time: `vibcli explain time`. Signals: `vibcli explain signals`. Plots and files: `--plot`, `--save`, see "
    "`vibcli explain pictures` and `vibcli explain data`.",
]

PHASE_PLANE = [
    "`vibcli response FILE --phase-plane` draws the motions of one degree of freedom x over x and x' in the terminal: "
    "orbits with arrows of their direction, separatrices, the orbit from `initial`, and the equilibria by their kinds. "
    "`--save plane.png` (svg, pdf) draws them in a file, `--json` tells places, kinds, eigenvalues, energies.",
    [
        ("kinds", "by the eigenvalues of λ² − a_v λ − a_q = 0, x'' = a(x, x'): a saddle where a_q > 0, a centre where "
         "energy is kept, else a stable or unstable focus, node, or degenerate node of two equal eigenvalues. Where "
         "those decide nothing the forces beside it do: a cusp, a saddle-node, and others so marked. Places at each of "
         "which the scene rests, as within a play, are a line of rest. At a kink there are no eigenvalues; the forces "
         "on both sides tell the kind."),
        ("conservative", "Orbits are level curves of H = ½ m(x) x'² + V(x), from one turning place to the other; a "
         "separatrix is the level of its saddle. The orbit from `initial` has its turning places and exact period."),
        ("damped", "Orbits are integrated forwards and backwards. Separatrices are what runs into a saddle, which "
         "bounds the starts that end in the same place, and what runs out of it, from the eigenvectors (1, λ). A limit "
         "cycle is the last lap of a motion from beside an unstable equilibrium."),
        ("range", "All equilibria that the search finds, within `find: {equilibria: all, within: {x: [-1 m, 1 m]}}` "
         "where that is given; where separatrices and the orbit from `initial` turn; of an angle a turn and more."),
        ("equations", "the full ones, also where `motion` is small; with `motion: {order: 3}` the expanded ones"),
    ],
    "Refused are several degrees of freedom, what depends on the time, dry friction, members, ropes (which may go "
    "slack), loops closed numerically, `damping:` of the whole, and letters.",
]

SWEEP = [
    "`vibcli sweep FILE --over 'k=400 N/m .. 1.2 kN/m' --of 'omega[1]' --of 'zeta[1]'` tells quantities over a "
    "parameter of the file: any that `answers` may ask for, and expressions of some; the natural frequencies unless "
    "named. The scene is derived once. Each value is that of the scene with this parameter, as `--set` gives it.",
    [
        ("--points N", "how many values; `--log` spaces them by one ratio, and pictures show decades. A bare number "
         "has the unit of the other end, or that of the file."),
        ("--over twice", "the grid of two parameters, as tables and contours"),
        ("branches", "omega[i] stays the i-th in ascending order. Natural modes are followed by their shapes besides: "
         "where branches change places, the branch of each mode stands beside it, and it is told where they cross, or "
         "veer: come near and take each other's shape."),
        ("gaps", "Where a quantity has no value its curve has a gap, and the reason is told once."),
        ("Campbell diagram", "over a rate, such as Omega of what turns, the lines ω = Ω and 2Ω are drawn too"),
        ("--plot, --save", "curves in the terminal, or in files: pictures, .csv, .npz, .json; `--json` tells all"),
    ],
    "What is chosen by the scene is chosen anew at each value. Not to be swept over is what other parameters define, "
    "and a range at whose ends there is no such scene. An interrupt keeps what was found.",
]

STEPS = [
    "`vibcli solve FILE --steps` tells the solution line by line: letters first, then the numbers put in.",
    [
        ("bodies", "the mass centre as it is, speeds to the first order about rest; T of a fixed axis ½ J_O ω², else "
         "½ m v² + ½ J_C ω², body by body, then the sum"),
        ("springs, weights, loads", "the stretch from rest, to the second order where a force at rest meets its "
         "curvature, else to the first; V = N Δ + ½ k Δ² with the tension N at rest, which the balance of forces "
         "gives; of a steady load −F s"),
        ("dampers", "the speed across each, to the first order; Φ = ½ c u̇²"),
        ("rest", "∂V/∂q = 0 of each coordinate, and where the forces balance if not as drawn. What is found in numbers "
         "alone has a letter, the value that a search found, and what that leaves of the forces; long coefficients "
         "there have letters, too."),
        ("turning frames", "T by powers of the speeds in them; −T without speeds acts like a potential"),
        ("constraints", "what they leave of the other coordinates, of closed loops to the second order from rest"),
        ("equations", "Lagrange's derivatives and the equation of one coordinate; of several the equations, then M, C, "
         "G and K as matrices, in letters and in numbers"),
        ("equations as they are", "where `motion: full`, `find: [equations]`, or an answer T, V or motion[q] asks for "
         "them, and where small oscillations are not told element by element: places, speeds, T, V, Φ, virtual "
         "work and Lagrange's derivatives unexpanded, of closed loops with multipliers; then the equations to the "
         "first order from rest"),
        ("frequencies", "ω² and ω with numbers put in, δ, ζ, ω_d; of two coordinates det(K − ω²M) = 0 by its entries "
         "and by powers, with iωG where frames turn, its coefficients and roots, ratios of amplitudes, modal masses "
         "and normal coordinates; whether damping is proportional; roots with damping; where they are asked, shapes of "
         "damped modes, bounds by assumed shapes, by Rayleigh and by Dunkerley"),
        ("motion", "of one coordinate the constants from `initial` and the motion with their numbers, and what loads "
         "bring about: X and θ under one harmonic or several, from the complex equation; the first harmonics of a "
         "square or sawtooth wave; steps, ramps and impulses piece by piece; what follows a growing load. Of several "
         "the complex amplitudes under each harmonic, of two and three by determinants of K − Ω²M + iΩC; of two or "
         "three what each mode "
         "starts with, a complex one where damping couples them, and their sum, under one harmonic beside what it "
         "keeps up, beats as a product; loads in pieces by what each brings about in a mode, others by the integral of "
         "their impulses; where they are asked, points of a response that the one damper of two degrees "
         "does not move."),
        ("wide motions", "of one coordinate that keeps its energy: the integral ½ m q̇² + V = E, where it turns, its "
         "greatest speed and its period; under dry friction the half cycles until it rests"),
        ("expansions", "where `find` asks for one: of each spring its deflection and its energy by powers of the "
         "deviations from rest, what of it its geometry makes, V and T, and Lagrange's equations of these"),
        ("members", "differential equation, what holds at each station and of what holds them, standing waves and "
         "their general solution, what the ends leave, the frequency equation, its first roots and their frequencies; "
         "where it has no closed form the equations, and frequencies by a search"),
        ("forces", "what is asked of constraints and supports, or all where nothing can move: the balance along each "
         "coordinate that takes part, accelerations from rest, then the values"),
        ("chosen parameters", "the condition solved last; which solution was taken"),
    ],
    "New letters never meet those of the scene. What the lines add up to is held against M, C and K of the engine, "
    "equations against those of the engine at states of motion, roots and forces against what they fulfil, before any "
    "line is told. `--json` gives each line as data: what it settles, from which lines, its expression and value. Not "
    "told are more than 12 coordinates, motions in time of members, other motions of equations that are not linear, "
    "and the motion of several coordinates from a start under loads.",
]

FREQUENCY_RESPONSE = [
    "`vibcli frf FILE` finds H(Omega), the complex amplitude of a signal of small oscillations over that of an input "
    "which vibrates with Omega; the signal lags behind the input by θ = −arg H. Without dampers peaks are infinite.",
    [
        ("input", "a force or moment by its name, 1 N or 1 N·m along the line in which the scene has it, whatever it "
         "is there; an unbalance, 1 kg·m; a driven point or body, displaced by 1 m; a coordinate, the generalised "
         "force 1 on it. The first of these in the file unless `--to` or `find` names one."),
        ("output", "any signal and its rates: `x` (receptance), `x'` (mobility), `x''`, `P.y`, `s.force`, "
         "`ground.force`"),
        ("unit", "that of the output over that of the input: m/N, 1 of a force by a force"),
        ("frequency", "rad/s, or Hz where the unit says so: `frf[x, drive](5 Hz)`"),
    ],
    "What `answers` and `choose` may ask:",
    [
        ("abs(frf[x, drive](5 Hz))", "amplitude for a unit of the input; also `phase`, `arg`, `re`, `im`"),
        ("peak[1](frf[x, drive]).Omega", "its first resonance, `.value` the amplitude there"),
        ("antiresonance[1](frf[x, drive])", "where it vanishes, or is least where it is damped; between distant places "
         "of a hundred coordinates that are no row of masses some may be missed"),
        ("half_power[1](frf[x, drive])", "where it is 1/√2 of peak 1 below it, `half_power[2]` above it; 3 and 4 of "
         "peak 2"),
        ("quality[1](frf[x, drive])", "Q of peak 1: its Omega over the distance of its half-power points"),
        ("fixed_point[1, d](frf[x, drive]).Omega", "through which all curves pass, whatever the damper `d` is; "
         "`.value` its height. An absorber is tuned by `k2: fixed_point[1, d](frf[x1, F]).value = "
         "fixed_point[2, d](frf[x1, F]).value`"),
        ("modal_frf[5, x, drive](5 Hz)", "the same as the sum of the first five modes that oscillate; "
         "`truncation[5, x, drive](5 Hz)` says how far that is off. Members have modes without end: `frf` itself is "
         "exact"),
        ("transmissibility[y, base](Omega)", "|H|: of motion from a driven point or body `base`"),
        ("transmissibility[ground.force, F](Omega)", "the part of a force that reaches the ground"),
    ],
    "An isolator: `choose: {k: \"transmissibility[y, base](Omega) = 0.1\"}`. An absorber that holds a machine still: "
    "`choose: {k2: amplitude(x1) = 0}`, as in `vibcli new tuned_absorber`.",
]

SIGNALS = [
    "Beside coordinates these can be asked for: in equilibrium `equilibrium[hoist.force]`, in modes `mode[1][P.y]` "
    "(no forces), in time `P.y(2 s)` and `max(s.force)`, over the frequency `frf[s.force, drive](5 Hz)`. In time they "
    "have rates `P.y'` and `P.y''`, and may be added and multiplied: `max(s.force + d.force)`, `max(s.force*x')`. "
    "Where a force jumps along a motion of the full equations its value is that just after; extremes count both sides. "
    "Springs, dampers, inerters, loads, constraints and members have names of their own, so that `s.force` is one.",
    [*signals.ABOUT, *member_signals.ABOUT],
]
