"""The elements of a scene, one to a file: its fields (schema, manual and messages at once) and its law.

By name the section of a scene that holds such elements, None of those that stand within others, and what it is, or its
section. Elements contribute to a scene in this order. A file is imported on the first use of its key, by fields.Lazy.
"""

ELEMENTS = {
    "point": ("points", "named places, fixed or carried"),
    "surface": ("surfaces", "what bodies roll, slide or lie on"),
    "body": ("bodies", "what moves, and how"),
    "slide": (None, "translates along a direction"),
    "pin": (None, "turns about a point"),
    "roll": (None, "rolls without slip on a surface"),
    "move": (None, "general plane motion [x, y, phi]"),
    "weld": (None, "carried rigidly by another body"),
    "clamp": (None, "held rigidly, with reactions and a clamping moment"),
    "turn": (None, "rotation of a body without a place"),
    "bar": ("bars", "elastic bars, along their axis"),
    "shaft": ("shafts", "elastic shafts, about their axis"),
    "beam": ("beams", "slender beams that bend"),
    "string": ("strings", "strings under tension"),
    "spring_part": (None, "what springs in series or parallel consist of"),
    "damper_part": (None, "what dampers in series or parallel consist of"),
    "spring": ("springs", "a spring between two ends"),
    "damper": ("dampers", "a damper between two ends"),
    "inerter": ("inerters", "an inerter between two ends"),
    "force": ("forces", "loads: forces, moments, generalised forces"),
    "constraint": ("constraints", "what ties motions together"),
    "energies": ("energies", "terms of T, V and Phi written out"),
    "matrices": ("matrices", "M, C and K given outright"),
    "damping": ("damping", "damping of all, by ratios of modes or in proportion"),
}
