"""The elements of a scene, one to a file: its fields (schema, manual and messages at once) and its law.

A file is imported on the first use of its key, by fields.Lazy; a test compares this list with the folder.
"""

NAMES = ("body", "body_checks", "constraint", "damper", "energies", "force", "gravity", "matrices", "move", "pin",
         "point", "rim", "roll", "rope", "shapes", "slide", "spring", "surface", "torsion", "turn", "weld")
