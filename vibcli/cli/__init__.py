"""The command line: one file a command, and what each is for."""

COMMANDS = {
    "solve": "The solution of a scene as a textbook writes it, or what its `find` asks.",
    "equations": "Energies and equations of motion, full and for small oscillations.",
    "frequencies": "Equilibrium, natural frequencies, damping and mode shapes.",
    "draw": "The scene as a textbook figure, or a mode shape on it.",
    "animate": "A mode, or the motion in time, as an animated gif or svg, or a page for the browser.",
    "response": "The motion in time, free or forced: numbers, plots, data files.",
    "frf": "Frequency responses: resonances, bandwidths, plots, data files.",
    "sweep": "Quantities over one or two parameters: tables, curves, contours.",
    "variants": "Homework of a problem: all variants solved, and the gates that they pass.",
    "homework": "Sheets of a problem or a set, one for each student, with keys and worked solutions.",
    "grade": "Mark answers by the manifest of the sheets that were handed out.",
    "view": "Report, figures and moving modes in the browser, as the file is edited.",
    "check": "Compare the answers in scene files with the results.",
    "bench": "Run time against true error of what a scene asks, beside other methods.",
    "stress": "Scenes that one knob makes ever harder: true errors beside the bounds that are stated.",
    "explain": "The manual of the scene language, word by word.",
    "schema": "The JSON Schema of scene files, for editors.",
    "new": "A commented scene to start from.",
}
