"""Packages of variants for the systems in which courses live, one format to a file: `package(course, questions)` of
each gives (path, bytes) of its files."""

FORMATS = {
    "canvas": "QTI 1.2 in the profile of Canvas: a quiz with a group of questions for each key",
    "moodle": "Moodle XML: a category of questions for each problem, numerical or cloze",
    "prairielearn": "PrairieLearn: a folder for each problem, whose server.py picks a variant",
    "qti21": "QTI 2.1: an item for each variant, and a test that picks one of each problem",
}
IN_TEX = "canvas", "moodle", "prairielearn"     # what the others show is in MathML
