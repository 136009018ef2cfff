"""The pages of the manual on run time against true error, and on stress. Data alone."""

BENCH = [
    "`vibcli bench FILE` answers what the file asks (or `--of omega`, `--of 'max(x)'`; all modes are one) by every "
    "method that can, and sets the run time of each against its true error: that beside values to many digits, which "
    "mpmath finds from the element data alone, with more and more digits until two numbers of digits agree. Where "
    "none do, the quantity is left out, never guessed.",
    [
        ("omega, zeta …", "`eigh` and `eig` of SciPy and NumPy on assembled matrices, `eig` of the state matrix and "
         "of its pencil; the error is the largest relative one of any mode"),
        ("max(x), x(2 s) …", "`solve_ivp` (RK45, DOP853, LSODA, Radau, BDF) and `odeint`, each at tolerances 1e-3 … "
         "1e-13, on equations that are compiled beforehand; of small motions also sums of 1 … n undamped modes, "
         "and `lsim`, whose steps have all samples of a record among them where that is possible. Extremes are the "
         "tops of parabolas through 4001 instants, or the steps of `lsim`. The error is relative to the largest value; "
         "records are straight lines between the samples that are read; forces that bend or stick are as they are "
         "written"),
        ("frf[x, F](5 Hz), amplitude(x), rms(x)", "LU of the matrix at that frequency, sums of 1 … n undamped modes"),
        ("equilibrium[x]", "`root` of SciPy (hybr, lm) on the forces at rest, with those of constraints"),
        ("K[x,x], M, C, G", "central differences of the forces, at steps 1e-1 … 1e-8; of M the kinetic energies of "
         "unit velocities"),
        ("sensitivity[1, m], V[x^4] …", "central differences, at the same steps, of what is solved anew, of energies "
         "and of forces; so stiffness[P].max, law[s, d^3], stiffness_correction[s, x]"),
        ("law[s](2 cm)", "`root` of SciPy on the deflections of parts in series"),
        ("fold[1, P], fold[1, P](x)", "`root` of SciPy, begun beside the fold, which ours has to look for: a tenth "
         "of the way back to the given equilibrium"),
        ("rayleigh, dunkerley, ritz[1]", "their formulas, by `solve` and `eigh` of assembled K and M"),
        ("J[b, O], centre[b].x, mass[b]", "sums over 1 … 1000 cells a side of its shapes, and Gauss's quadratures "
         "of 1 … 32 points"),
        ("backbone[1](x)(10 cm)", "the integrators, over two periods of one coordinate"),
        ("omega, zeta, frf of members", "1 … 128 finite elements a piece, and `eigh`, `eig`, LU at that frequency, "
         "or sums over their modes where `damping:` gives these ratios"),
        ("k, k[2] that are chosen", "none: what the conditions determine by true values stands beside ours"),
        ("peak[1](frf[x, F]).value", "grids of 100 … 1,000,000 frequencies, with parabolas and without"),
    ],
    "vibcli itself begins with the element data, finds its modes anew, and states a bound, which stands beside its "
    "true error. Times are of the processor: medians of 7 runs by turns after one that does not count (3 with "
    "`--quick`, or where one takes over half a second; one where all would take too long), with quartiles. What takes "
    "over 5 s and a hundred times as long as vibcli itself is stopped. A method that has no answer is left out; one "
    "that gives a wrong number of values, or refuses, says so instead of an error.",
    "All runs of a file share half a minute of processor time: what would take longer is left out, and says so. A full "
    "motion whose true values take more is compared up to an earlier end, which is told.",
    "Below stand the stages of the scene: what each took that was needed, and what those that were skipped would have "
    "cost. `--skipped` shows for each question which stages it takes, and which packages and rooms of the program it "
    "imports, by asking it in a process of its own.",
    "`vibcli bench FILE --json > old.json`, and later `vibcli bench FILE --against old.json`: the ratios of run times "
    "to those of the other methods beside the older ones; a row is worse where its ratio has grown by more than 30 % "
    "and by three times its spread, in two runs out of two (exit code 1); where no row is on both sides nothing is "
    "compared (exit code 4).",
    "`-o curve.svg` (png, pdf) draws it: relative error across, time up, a cross at the edge for what was refused or "
    "stopped; `-o table.md` (html, txt) writes the tables; `--json` holds all points, and with `error below` "
    "says of an error that the digits of the true value show no smaller one. Letters without value are given the same "
    "ones at every run, which are told. Without FILE the project's own measurements are made, against budgets; `--only "
    "PART` takes some.",
]

STRESS = [
    "`vibcli stress` solves families of scenes, each of which one knob makes harder from point to point: stiff beside "
    "soft springs, damping from 1e-12 to 1e8, loads ever nearer to resonance or to buckling, ever longer times … Each "
    "point is answered as every scene is, and stands beside its true value: one that mpmath finds from the element "
    "data, with more and more digits until two numbers of digits agree, or a closed form in as many. Errors and bounds "
    "are relative: of modes to each eigenvalue, of motions to their largest value; of several numbers those are told "
    "whose error comes nearest to its bound.",
    [
        ("condition", "what the plain way multiplies the rounding of its data with: of modes (ω_max/ω_min)², of damped "
         "ones the largest of their eigenvalues', of a response that of K + iΩC − Ω²M, of a peak |λ|/(2 |Re λ|), of a "
         "motion ω t"),
        ("plain error", "that of a method without such care: eigh or eig of assembled matrices, an integrator, a grid "
         "of frequencies, a formula in floats; none where it gives no answer"),
        ("held", "the error is within the bound that is stated"),
        ("escalated", "so it is, by more digits of the data than floats have"),
        ("refused", "no answer is given, with the reason"),
        ("broken", "the error exceeds the bound: a fault of the program; exit code 1"),
        ("idle bound", "a bound over 1e4 times as large as the error and the rounding of the value (1e6 where a motion "
         "is integrated): true, but of little use"),
    ],
    "`--family NAME` takes some; `-o FOLDER` draws error, bound and plain method of each over its knob; `--json` "
    "holds them as data.",
    "`vibcli stress FILE` shakes a scene. Without members its modes are found again of the same element data written "
    "otherwise: masses, dampers and stiffnesses by four, times by a half, the units of some coordinates by two, or "
    "these the other way round, which has to leave every bit of them as it is; coordinates and elements from the last "
    "to the first, each spring as two in parallel or in series, which have to stay within the bounds of both. Then "
    "the whole scene is read and solved again with its lengths, masses or times four times as large, which has to "
    "leave every bit of its place of rest and of its modes (with members their bounds, as the place of rest where "
    "lengths stand beside angles and nothing is drawn), its elements in another order, and each spring as two in "
    "parallel, and what is drawn in the plane is seen in a mirror; all answers that are numbers, motions too, have to "
    "stay within their bounds.",
    "Last, each figure of the file that is written with three digits or more (fewer are exact), in parameters or "
    "elsewhere, is moved by half a unit of its last digit: told is how many digits of each answer the data support, "
    "−log₁₀ of the sum of the relative changes, and which figure takes most of them. Cases are shaken with --case, but "
    "what they alone give is not moved. Letters without value are given the same ones at every run, which are told and "
    "not moved.",
    "Of any scene `--timings`, and `certificate` of `--json`, tell what is left of the equations when the results are "
    "put back into them: of modes ‖λ²Mφ + λ(C + G)φ + Kφ‖ over (|λ|²‖M‖ + |λ|‖C + G‖ + ‖K‖)‖φ‖ n ε, as LAPACK's tests "
    "have it, of their orthogonality ‖ΦᵀMΦ − I‖/(n ε), of rest the forces over ε and the size of their terms: up to 20 "
    "they are rounding. Of motions that were followed it is work of the loads − what is dissipated − the change of "
    "T + V, relative to the largest of these. A place of rest where more than rounding is left of the forces is found "
    "anew in more digits, as modes are whose bound is wider than a float needs.",
    "A figure with ? behind it has fewer digits than others (six), since the bound of its error allows no more. With "
    "`--strict` nothing is printed then (exit code 4), nor where a residual ratio is over 20.",
]
