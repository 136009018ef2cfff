"""Pages of the manual on homework. Data alone."""

from vibcli.homework.mistakes import FORMULA, MISTAKES, MODEL, READING
from vibcli.reader.sections.variants import GATES


def _of(kind: str) -> list[tuple[str, str]]:
    return [(name.replace("_", " "), about) for name, (its, about) in MISTAKES.items() if its == kind]


HOMEWORK = [
    "`variants:` in a scene file says which values its parameters take in homework; what `solve` and `check` find does "
    "not hang on it. The candidates are the grid of all values under `parameters` and `rows`, these being one axis; "
    "each is solved, and kept as a variant where it passes all gates: `vibcli variants FILE` tells how many, "
    "`--table` and `--rejected` list them, `--at-least N` exits with 1 where fewer are left.",
    [("solved", "there is such a scene, and it has such an answer"), *GATES.items()],
    "`without: [told]` switches gates off. A candidate is counted with the first gate that it fails, in this order.",
    [
        ("values", "as they are printed: steps are exact decimals; `series: R10` takes the preferred numbers of ISO 3 "
         "between the ends. A parameter without a value may be varied too, so that a scene in letters has numbers."),
        ("chosen parameters", "What is not asked is rounded as `printed` says, to three figures unless given, and the "
         "scene is solved again from the printed values: keys are those of what the student reads."),
        ("ask", "what is asked, in which unit, for how many points; what `answers` ask that is a number unless given, "
         "and where letters are left all that they ask"),
        ("letters", "Where parameters are left without value, keys are expressions of these, with the numbers of the "
         "others: any that is equal is right, as `check` compares them, and nothing else; a mistake must be unequal. "
         "Energies and equations may be asked there, too."),
        ("equations", "Of a scene with numbers `equation[x]` and `motion[x]` may be asked: an answer is right up to a "
         "factor where each coefficient lies in its band, 1 % at three figures, and it has no other terms. An equation "
         "with numbers within its functions is not asked."),
        ("figures", "An answer is asked to three figures; where the band of a mistake would meet that of the key, to "
         "four, then to five. A variant in which that does not help is rejected."),
        ("bands", "how far a right answer may lie from its key: what rounding to these figures does along the lines of "
         "the worked solution, in 99 of 100 cases, by the slopes of the key along them; half a per cent where no line "
         "tells the key; `rtol` in `ask` overrides. A variant whose band is wider than 2 % is rejected."),
        ("mistakes", "those that `vibcli explain mistakes` lists, as far as they concern the scene, and parts of the "
         "scene, merged over it as cases are, and solved anew: `weight forgotten: {gravity: 0}`; wrong values by other "
         "quantities: `natural for damped: {answers: {\"omega_d[1]\": \"omega[1]\"}}`. What one gives a "
         "parameter holds in all variants. One that leads to the key in every variant is told and left out, and so is "
         "one of the list that leads to nothing in any; one of the file that does is refused; `damped for natural: "
         "off` switches one of the list off."),
        ("sample", "so many candidates of a larger grid, the same ones on every machine"),
        ("--jobs N", "Grids of more than 10,000 candidates are solved in equal parts of at most so many, N at a time, "
         "and so are the problems of a set; sheets and packages are made for at most 25 students or items at a "
         "time. `--cluster ADDRESS` has a scheduler of dask.distributed "
         "(`vibcli[cluster]`) give them to its workers. What is found and written is the same, to the byte."),
    ],
    "`vibcli homework SET -o FOLDER` hands out a problem file, a folder of them or a `set.yaml`, to the students of a "
    "roster (`--students roster.csv`), by a secret text (`--salt-file F`): under `student/` a sheet for each student, "
    "under `instructor/` the key of each variant with its worked solution, `keys.csv`, an overview and "
    "`manifest.json`. `--paper N` numbers sheets instead. Sheets are PDF where `vibcli[homework]` is installed, else "
    "HTML pages. Packages for Moodle and other systems: `vibcli explain exports`.",
    [
        ("set.yaml", "`{title: Week 3, course: Dynamics, due: Friday, problems: [lever.yaml, {file: shafts.yaml, case: "
         "stiff, points: 4}, {file: more, pick: 2}]}`: of a folder each student gets so many problems. Its schema for "
         "editors: `vibcli schema --set`"),
        ("roster", "a CSV file with a heading: `id`, and perhaps `name`"),
        ("who gets what", "In the order of the roster each the first variant still free in a permutation of their own, "
         "made of hashes of the salt, the problem, the id and `--attempt`: none share while variants last, and who is "
         "added at the end changes nobody's sheet. A variant is passed over for a student on whose sheet its "
         "key would stand by chance, in its own problem or another. `--distinct` refuses where students would share."),
        ("files", "A record or table from which a problem takes numbers lies with the sheets under its own name, and "
         "stands in the manifest."),
        ("leaks", "No student's file tells a key at three or more figures, the text of one that is an expression or "
         "equation, the salt or a comment of the scene: else nothing is written."),
        ("again", "The same input gives the same bytes; `--from-manifest` writes the sheets of a manifest again, "
         "whatever became of the files; one that was edited is refused."),
    ],
    "What comes back is marked by `vibcli grade manifest.json`: `vibcli explain grade`.",
    "Cases do not inherit variants; a case may have its own (`--case`). All variants share one derivation where no "
    "sign of the drawing hangs on their values; twenty are held against the scene read anew from the printed values.",
]

GRADE = [
    "`vibcli grade manifest.json` marks answers: `--student s1 --answer 'omega[1]=21.9 rad/s'` those of one, "
    "`--csv answers.csv -o marks.csv` those of all (columns `id`, `problem`, one for each quantity). Without a unit "
    "the one that was asked is meant; decimal commas are read, and the name of what is asked before it, as in "
    "`ζ = 0.2`; a mistake that is known is named, and of another wrong "
    "answer is said how it differs from the key: by its sign or a factor, by which term of an equation, else roughly. "
    "How far it is off, and how far it may be, tells the key: that stands in the text and in `--json` (`off`, `band`), "
    "not in the table, which may be given back. Expressions and "
    "equations are read as those of scenes are, also with ẍ, · and ²: `--answer 'omega[1]=sqrt(k/m)'`, `--answer "
    "\"equation[x]=2*x'' + 800*x = 0\"`. `--json` prints `marks` "
    "with the columns of the table, `off`, `band` and `unit`; `points` and `of`. The exit code is 0 whatever the marks "
    "are.",
    [
        ("--student", "whose answer `--answer QUANTITY=TEXT` is, which may be given several times; `--problem NAME` on "
         "a sheet with several"),
        ("--csv FILE", "the answers of all, marked into `-o marks.csv`"),
        ("bands", "Right is what lies within the band of the key, its edges included: `vibcli explain homework`."),
    ],
    "Course systems mark by the same bands: `vibcli explain exports`.",
]

KNOWN_MISTAKES = [
    "What leads to a wrong answer, as students make it. `vibcli check` names the mistake that leads to an answer which "
    "differs; `vibcli variants` rejects a variant in which one would be marked right. Those of the model change the "
    "scene and solve it anew. A scene may name more of its own: `vibcli explain homework`.",
    "Of reading:", _of(READING), "Of formulas:", _of(FORMULA), "Of the model:", _of(MODEL),
]
