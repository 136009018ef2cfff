"""Texts of the manual on pictures, reports and data files. Data alone."""

PICTURES = [
    [
        ("vibcli draw FILE", "the scene as a figure, drawn to scale; lumped bodies in a row along their axis"),
        ("vibcli draw FILE --mode 1", "the shape of a mode over the scene at rest; `--both` the other way as well"),
        ("vibcli animate FILE --mode 1", "the mode in motion: .gif, or .html with play, pause and a slider; "
         "`--response` the motion in time, `--until 2` so long"),
        ("vibcli response FILE --plot", "the motion plotted in the terminal; `--of x` says which signals, `--until 2` "
         "how long, `--steady` and `--transient` add these parts"),
        ("vibcli frf FILE --plot", "amplitude and phase; `--from`, `--up-to` give the range, `--nyquist` the complex "
         "plane"),
        ("--save FILE", "the same plot as .png, .svg or .pdf"),
        ("--pictures", "the figure and the mode shapes within a report: `vibcli explain reports`"),
    ],
    "`draw` and `animate` write .png and .gif under the name of the scene, or the file that `-o` names: .svg, .pdf, "
    ".html. No file is replaced without `--force`. A scene with symbols can be drawn; its modes need numbers.",
]

REPORTS = [
    "`solve`, `equations`, `frequencies`, `response` and `frf` print their report as text. `--format markdown`, "
    "`latex` or `html` writes it otherwise; `-o FILE` writes it to a file, in the form of the suffix.",
    [
        (".txt", "as in the terminal"),
        (".md", "Markdown with formulas between dollar signs"),
        (".tex", "a LaTeX document of its own"),
        (".html", "a page complete in itself, its formulas in MathML"),
        (".json", "the same as `--json`: `vibcli explain json`"),
    ],
    "`--pictures` adds the figure of the scene and the shapes of its modes, within .html, as files beside .md (.svg) "
    "and .tex (.pdf). `vibcli solve problem.yaml -o report.html --pictures` writes the whole.",
]

DATA = [
    "`vibcli response FILE --save FILE` and `vibcli frf FILE --save FILE` write the sampled curves in SI units, "
    "angles in radians, by the suffix:",
    [
        (".csv", "a first row of names with units, as in `x [m]`, then numbers that read back exactly"),
        (".npz", "for NumPy: an array under each name; `units` lists the names with units"),
        (".json", "title, and columns with `name`, `unit`, `values`"),
    ],
    "The first column is `t`, or `Omega`. `--points N` says how many instants; frequencies lie densest where a curve "
    "bends. A complex response has the columns `re x` and `im x`. `steady x` and `transient x` are there where "
    "`--steady` and `--transient` ask for them.",
    "Numbers read off the curves (extremes, steady states, peaks): `--json`.",
]
