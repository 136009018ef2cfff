"""The page on Python. Data alone: the names that it tells are those of vibcli/api/."""

PYTHON = [
    "`import vibcli` opens scenes for Python as the commands do for the shell. Values are in SI units, angles in "
    "radians; arrays are those of NumPy. Nothing is computed before it is asked for, nor twice.",
    [
        ("vibcli.load(scene)", "the `Model` of a scene: of the file of that name, or of a mapping that holds what a "
         "file would"),
        ("vibcli.loads(text, folder=\".\")", "that of the text of a scene, with its records in a folder"),
        ("p.case(name)", "a case of the scene, itself a `Model`; `p.cases` lists them"),
        ("p.with_values(k=600, m=\"2 kg\")", "the scene with other values: numbers in the unit of the file, texts with "
         "their own, as with --set"),
        ("p.with_accuracy(1e-6)", "the scene with motions that are integrated so accurately, as with --accuracy"),
        ("p.coordinates", "the names of the degrees of freedom"),
        ("p.omega", "natural angular frequencies, ascending; `p.zeta` damping ratios by damped mode"),
        ("p.modes", "mode shapes as columns, the first coordinate that moves being 1"),
        ("p.equilibrium", "values of the coordinates in equilibrium, by name"),
        ("p.equations[\"x\"]", "an equation of motion: `.text`, `.latex`, of small oscillations `.linear_text`, "
         "`.linear_latex`; `.to_sympy()`, `.to_sympy(linear=True)`; its `.coordinate`"),
        ("p[\"max(x)\"]", "any quantity that `answers` may ask for, or an expression of some: `.value`, `.unit`, "
         "`.error` (an absolute bound in that unit), `.expression` instead of a value where it is one, `.text` as "
         "asked"),
        ("p.response(until=\"2 s\")", "the motion in time: `.t`, and an array for each signal, as in r[\"x\"], "
         "r[\"s.force\"]; `.unit(signal)`; `.unknown` says why it is not known to its end; `points=1001` instants"),
        ("p.frf(\"x\", \"drive\", omega=array)", "the complex frequency response of a signal to a unit of an input, at "
         "angular frequencies in rad/s, or at frequencies in Hz with `f=array`"),
        ("p.sweep(\"omega[1]\", \"zeta[1]\", k=array)", "quantities over ascending values of a parameter, or over the "
         "grid of two, in the unit of the file: `.over`, `.values` and `.units` by name, `.branches` of natural modes, "
         "`.meetings`, `.gaps`"),
        ("p.variants()", "the variants of a scene as homework: `.accepted`, each with `.values` as they are printed, "
         "`.keys` in the unit asked (expressions and equations as texts), `.bands` and `.mistakes` by quantity; "
         "`.counts` by gate, `.units`, `.rejected` with their reasons; `p.variants(executor)` has an executor of "
         "`concurrent.futures` solve the parts of a large grid"),
        ("p.draw()", "the figure; `p.draw(mode=1, both=True)` a mode shape on it. `.save(\"scene.png\")` writes it, "
         "`.data(\"svg\")` gives its bytes; `.title` and `.about` say in words what it is and shows"),
        ("p.diagrams()", "forces and moments along members in equilibrium; `p.diagrams(mode=2)`, `p.diagrams(at=0.04)` "
         "at an instant in seconds, `p.diagrams(amplitudes=True)`"),
    ],
    "A notebook shows a `Model` as its report with the figure. In a scene with letters without value `p.omega`, "
    "`p.zeta`, `p.modes`, `p.equilibrium` and `.expression` are expressions: str() writes them in the scene language; "
    "`.latex`, `.to_sympy()`.",
    "`vibcli.SpecError` is raised where exit code 3 stands: the scene, or what is asked of it, is invalid; "
    "`vibcli.PhysicsError` where exit code 4 stands: there is no such answer, for a physical cause. Both have "
    "`.diagnostics`, a list of all that is wrong: `.message`, `.hint`, `.where` with file, line and column; of a "
    "mapping the path of keys stands for the file: `bodies.block.mass`.",
]

EXAMPLE = """import vibcli

p = vibcli.loads('''
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
dampers: {d: {c: c, between: [ground, block]}}
forces: {drive: {at: block, force: (10 N)*sin((15 rad/s)*t)}}
initial: {x: 1 cm}
''')
print(p.omega, p.zeta)              # [20.] [0.1]
print(p.equations["x"])             # m*x'' + c*x' + k*x = 10*sin(15*t)
found = p["amplitude(x)"]
print(round(found.value, 6), found.unit)    # 0.027027 m
motion = p.response(until="500 ms", points=6)
print(motion.t[-1], motion["x"][0].round(9))    # 0.5 0.01
print(abs(p.frf("x", "drive", omega=[0, 15])).round(6))    # [0.00125  0.002703]
print(p.with_values(k=3200).omega)  # [40.]
try:
    p["max(y)"]
except vibcli.SpecError as error:
    print(error.diagnostics[0].message)  # this scene has no coordinate or signal 'y'"""
