"""How plots look in files: sizes, and colours and dashes that a colour-blind reader tells apart too."""

# M. Okabe and K. Ito (2002), Color Universal Design; the yellow is left out: too light on white.
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
COLOURS = (BLUE, VERMILION, GREEN, PURPLE, BLACK, ORANGE, SKY)
DASHES = ("-", (0, (6, 2)), (0, (5, 1.5, 1, 1.5)), (0, (2, 1)), (0, (9, 2)), (0, (4, 1, 1, 1, 1, 1)), (0, (1, 1)))
POINTS = ((VERMILION, "x"), (BLUE, "o"), (GREEN, "^"), (PURPLE, "s"), (BLACK, "D"))
GREY, LIGHT, MIDDLE = "#555555", "#E3E3E3", "#9A9A9A"

WIDTH, HEIGHT = 6.5, 3.3                  # of a figure; of axes, in inches
RATIO = 1.2                               # width to height of axes with equal scales
PAD, GAP, ROOM = 0.08, 0.16, 10.0         # around the figure; between panels; a page to measure on
TITLE, LABEL, TICK, SMALL = 11, 10, 9, 8  # points
DOTS = 160                                # of a PNG, per inch
FINE = 1200                               # columns that a line is thinned to
CROWDED = 250                             # turns from which a line is drawn thin and solid
RC = {"text.parse_math": False, "text.usetex": False, "svg.hashsalt": "vibcli", "svg.fonttype": "path",
      "pdf.fonttype": 3, "axes.unicode_minus": True}
