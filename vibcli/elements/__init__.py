"""The elements of a scene, one to a file: its fields (schema, manual and messages at once) and its law.

A file is imported on the first use of its key, by fields.Lazy; a test compares this list with the folder.
"""

NAMES = ("answer", "body", "coordinates", "damper", "energies", "equilibrium", "find", "fitting", "gravity", "matrices",
         "move", "parameter", "pin", "point", "roll", "shapes", "slide", "spring", "surface", "turn", "weld")
