"""Sections of a scene file that are no element, one to a file."""

NAMES = {
    "coordinates": "their order, what each measures, its value as drawn",
    "equilibrium": "where the search of the equilibrium starts",
    "gravity": "the weight of everything that has a place",
    "initial": "where a motion starts: positions and velocities, or a force that lets go",
    "parameter": "what is given: a number with its unit, an expression, or a letter",
    "record": "a measured function of the time, from a file",
}
