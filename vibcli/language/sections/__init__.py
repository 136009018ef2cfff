"""Sections of a scene file that are no element, one to a file."""

NAMES = {
    "coordinates": "the generalised coordinates in the order wanted, with a word on what each measures",
    "equilibrium": "which equilibrium is meant",
    "gravity": "the acceleration of gravity, downwards (along −y), or a vector",
    "initial": "where a motion in time starts",
    "law_table": "laws of springs and dampers from points",
    "motion": "what motions in time are",
    "parameter": "what is given",
    "record": "measured functions of the time",
}
OWN_OF_CASES = ("cases", "answers", "find", "variants")        # that a case does not inherit
