"""The elements of a scene, one to a file: its fields (schema, manual and messages at once) and its law.

A file is imported on the first use of its key, by fields.Lazy.
"""

NAMES = {
    "body": "a rigid body or a point mass: what it is, where it is drawn, how it moves",
    "body_checks": "which keys of a body go together",
    "constraint": "what ties motions together: equations, gears, belts, links, joints",
    "damper": "a damper between two ends: viscous, of a law, or of dry friction",
    "energies": "terms of T, V and Φ written out",
    "force": "a load: a force at a point, a moment, a generalised force, an unbalance",
    "matrices": "M, C and K given outright",
    "move": "general plane motion: two displacements and a rotation",
    "pin": "rotation about a pin, fixed or carried",
    "point": "a named place, fixed or carried",
    "rim": "the circle of a body, on which it rolls and carries ropes",
    "roll": "rolling without slip on a line or a circle",
    "rope": "a rope over and around pulleys and drums",
    "shapes": "uniform plane bodies: mass centre and moment of inertia",
    "slide": "translation along a direction or a curve",
    "spring": "a spring between two ends: linear, preloaded, with a gap, or of a law",
    "surface": "what bodies roll or slide on: lines, circles, curves",
    "torsion": "springs and dampers between rotations",
    "turn": "rotation of a body that has no place",
    "weld": "a body fixed rigidly to another one",
}
