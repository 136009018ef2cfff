"""The page of the manual on packages for course systems. Data alone."""

EXPORTS = [
    "`vibcli homework SET -o FOLDER --export moodle --pool 40 --salt-file F` writes, instead of sheets, a pool of "
    "variants as a package for the system of a course, `--export` several times for several: the first N of a "
    "permutation by the salt, so that a larger pool holds the smaller one. The packages hold the keys and lie under "
    "`instructor/`, with the keys on paper and the manifest. What asks, which figures, values, mistakes and worked "
    "solutions they have is what sheets and keys have.",
    [
        ("moodle", "Moodle XML: a category of questions for each problem, numerical for one key, cloze for several"),
        ("prairielearn", "PrairieLearn: a folder for each problem, to be put under `questions/` of a course; its "
         "server.py picks a variant"),
        ("qti21", "QTI 2.1: a package with an item for each variant, and a test that picks one of each problem"),
        ("canvas", "QTI 1.2 in the profile of Canvas: a quiz with a group of questions for each key"),
    ],
    [
        ("items", "A variant is an item with a name, `lever-17`, the same when it is written again: with it begins the "
         "question's name in Moodle and its title in Canvas, PrairieLearn shows it below the question, and in QTI it "
         "is the identifier. In the manifest it is a student with this id: `vibcli grade manifest.json "
         "--student lever-17 --answer 'omega[1]=21.9'` says what `grade` gives and which mistake it sees; key, band "
         "and what mistakes give stand there beside. A variant that would by chance tell a key, by a "
         "value, a number in its question or its own number, is in no pool."),
        ("bands", "The band of a key is that of `grade`, its edges included. Beyond it the bands of mistakes, cut "
         "where two meet, are wrong and tell the mistake by name; of two that give the same, either."),
        ("by hand", "Expressions and equations, which no system compares, are questions of their own that are marked "
         "by hand; the key stands for who marks, in Canvas under `instructor/keys/` alone. The command tells which."),
        ("files", "A figure is an SVG in letters with its description as alternative text; a file from which a problem "
         "takes numbers is attached. In Moodle each question holds its own copies, elsewhere those of a problem stand "
         "once."),
        ("again", "The same input gives the same bytes, and a second import replaces where a system does that by "
         "names: PrairieLearn, QTI; so do there problems of another set with the same names. Moodle and Canvas add "
         "what is imported: delete the category, or the quiz, first."),
    ],
    "What differs from `grade`, by what the formats can do:",
    [
        ("units", "Moodle's numerical questions, PrairieLearn, QTI and Canvas take numbers alone: an answer with a "
         "unit is no number there, and counts as unreadable or blank. Cloze questions of Moodle leave out whatever "
         "follows the number: 209 rpm is wrong there, and 21.9 Hz or 21.9 kg right, for 21.9 rad/s."),
        ("commas", "Moodle and Canvas read decimal commas where the language of the site writes them so, else as "
         "separators of thousands; PrairieLearn and QTI do not read them."),
        ("powers", "2.19e1 is read everywhere, 2.19*10^1 by `grade` and Moodle alone; `grade` reads no more than 200 "
         "signs."),
        ("few figures", "`grade` says of 29.4 for 29.418 that it is right as far as it goes, and by the figures of an "
         "answer which mistake it may be; the systems say that it is wrong, and compare by the band alone."),
        ("zero", "A key that is 0 has no relative band: nothing else is right."),
        ("moodle", "adds 1e-14 of the key to each tolerance, which is taken off before. The weights of a cloze "
         "question are whole numbers: points that are not whole are written in their ratio."),
        ("prairielearn", "adds its two tolerances: `rtol` is the band, `atol` is 0. A seed picks the variant by its "
         "remainder."),
        ("canvas", "rounds answers to four decimals before it compares: keys are asked in units in which they lie "
         "between 0.1 and 1000, and answers within 0.00005 of the edge of a band may be marked otherwise. Each band in "
         "its packages is a right answer: mistakes are listed in what is said of wrong ones, once results are shown. "
         "Questions with several keys become groups of their own, which draw their variants each by itself."),
        ("qti21", "A player marks where the item is shown, so that who has the item may read the key: give packages "
         "to platforms that mark on their server."),
    ],
    "Tried (`make peers` in the sources): `moodle2amc` reads key and band of numerical questions; "
    "@citolab/qti-components marks each item of QTI in Chromium as `grade` does, shows its MathML as plain letters "
    "and gives its fields no names; the element of PrairieLearn marked 240 answers as the model of it in the tests; "
    "packages for Canvas are built as those of `text2qti` are.",
    "Held against published definitions: items, tests and manifests of QTI 2.1 are valid by its schemas. Quizzes for "
    "Canvas are valid by the definition of QTI 1.2 but for `points_per_item`, which is Canvas's own, their settings by "
    "what Canvas's schema says of a quiz, and their manifest by that of IMS content packages, but for its namespace. "
    "For Moodle XML there is no schema: its questions hold only elements that Moodle's importer reads.",
    "Not tried: cloze questions in another program, and import by Moodle, PrairieLearn and Canvas themselves.",
]
