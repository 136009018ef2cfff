"""Texts of the manual on pictures, reports and data files."""

from vibcli.base.enumeration import listed
from vibcli.report.formats import FORMATS, WITHIN

PICTURES = [
    [
        ("vibcli draw FILE", "the scene as a figure, drawn to scale; lumped bodies in a row along their axis"),
        ("vibcli draw FILE --mode 1", "the shape of a mode over the scene at rest; `--both` the other way as well"),
        ("vibcli draw FILE --diagrams", "forces, shears, moments and torques along members in equilibrium, below the "
         "scene; `--mode 2` of a mode, `--at '40 ms'` of the motion in time, `--amplitudes` of the steady state; "
         "`--plot` in the terminal"),
        ("vibcli animate FILE --mode 1", "the mode in motion: .gif, .svg, or .html with play, pause and a slider; "
         "`--response` the motion in time, `--until 2` so long"),
        ("vibcli response FILE --plot", "the motion plotted in the terminal; `--of x` says which signals, `--until 2` "
         "how long, `--steady` and `--transient` add these parts"),
        ("vibcli response FILE --phase-plane", "orbits of one degree of freedom over its place and speed"),
        ("vibcli frf FILE --plot", "amplitude and phase; `--from`, `--up-to` give the range, `--nyquist` the complex "
         "plane"),
        ("--save FILE", "the same plot as .png, .svg or .pdf"),
        ("--pictures", "the figure, the mode shapes and the diagrams of members within a report: "
         "`vibcli explain reports`"),
    ],
    "`draw` and `animate` write .png and .gif under the name of the scene, or the file that `-o` names: .svg, .pdf, "
    ".html. In an .svg words are text, and for who cannot see it stands what it shows; one that moves stands still on "
    "paper and where the reader wishes for less motion. No file is replaced without `--force`. A scene with symbols "
    "can be drawn; its modes need numbers.",
    "A body without a shape is drawn as what it carries and how it moves show it; its key `looks` says otherwise: "
    "`vibcli explain looks`.",
    "In diagrams each member is a base line. Bending moments stand on the side in tension; all else that is positive "
    "stands to the left of the way from the left end of the member to its right one, upwards where that runs to the "
    "right. Values stand at ends, at jumps and where the curve is largest; rings mark where it is zero. Signs are "
    "those of the signals: `vibcli explain signals`.",
]

_BESIDE = [f"{suffixes[0]} ({where})" for suffixes, where, _ in FORMATS.values() if where not in (None, WITHIN)]
_WITHIN = [suffixes[0] for suffixes, where, _ in FORMATS.values() if where == WITHIN]
REPORTS = [
    "`solve`, `equations`, `frequencies`, `response` and `frf` print their report as text. `--format "
    f"{listed([f'`{name}`' for name in FORMATS if name != 'text'], 'or')[1:]} writes it otherwise; `-o FILE` writes "
    "it to a file, in the form of the suffix.",
    [
        *((suffixes[0], about) for suffixes, _, about in FORMATS.values()),
        (".json", "the same as `--json`: `vibcli explain json`"),
    ],
    "`--pictures` adds the figure of the scene, the shapes of its modes and the diagrams of its members, within "
    f"{listed(_WITHIN)}, as files beside {listed(_BESIDE)}. `vibcli solve problem.yaml -o report.html --pictures` "
    "writes the whole.",
    "`vibcli view FILE` shows the report with its pictures, and modes that move, in the browser and follows the file "
    "as it is edited: of what has changed only the scene or the case concerned is solved anew, and what is wrong "
    "stands on top with its line. The page is served to this machine alone, under the address that is printed; "
    "`--no-open` opens no browser, `--port N` says where.",
    "`vibcli solve FILE --format scene` prints the file itself with what it found as its `answers`, in letters or to "
    "six digits (`--digits` otherwise), ready to be checked: comments, order and the answers that are there stay, "
    "those of a case stand in it. Each is compared as `vibcli check` does it; what does not agree, or has no spelling "
    "as an answer, is left out and named on stderr. `-o FILE.yaml` writes it to a file, `--force` in the place of one.",
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
    "`--steady` and `--transient` ask for them. A motion whose digits run out ends there: a last row has the end "
    "that was asked for and no values, empty in .csv, nan in .npz, null in .json.",
    "Numbers read off the curves (extremes, steady states, peaks): `--json`.",
]
