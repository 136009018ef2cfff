"""The names of what can be wrong with a file of problems, the same in every form in which a check is told."""

RULES = {
    "answer-differs": "an answer of the file is not what the scene gives",
    "answer-uncertain": "whether an answer agrees is beyond what the error bound of the result leaves open",
    "scene-invalid": "the file is no scene: a slip of writing, a word that there is not, units that do not fit",
    "cannot-be-solved": "the scene is well written but has no such answer, for a physical cause, or none that is known",
    "own-fault": "a fault of vibcli itself, not of the file: please report it",
    "taken-in-radians": "a number without a unit, beyond a full turn, is an angle in radians: a warning, no error",
}
DIFFERS, UNCERTAIN, INVALID, UNSOLVED, FAULT, DOUBTFUL = RULES


def level(rule: str) -> str:
    """How grave it is: error or warning."""
    return "warning" if rule == DOUBTFUL else "error"
