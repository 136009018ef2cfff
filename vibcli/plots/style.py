"""How plots look in files: sizes, and colours and dashes that a colour-blind reader tells apart too."""

# M. Okabe and K. Ito (2002), Color Universal Design; the yellow is left out: too light on white.
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
COLOURS = (BLUE, VERMILION, GREEN, PURPLE, BLACK, ORANGE, SKY)
DASHES = ("-", (0, (6, 2)), (0, (5, 1.5, 1, 1.5)), (0, (2, 1)), (0, (9, 2)), (0, (4, 1, 1, 1, 1, 1)), (0, (1, 1)))
POINTS = ((VERMILION, "x"), (BLUE, "o"), (GREEN, "^"), (PURPLE, "s"), (BLACK, "D"))
GREY, LIGHT, MIDDLE = "#555555", "#E3E3E3", "#9A9A9A"

WIDTH, COLUMN, HEIGHT = 6.5, 4.4, 4.0     # of a figure; of one in a page; of a panel with its labels, in inches
RATIO = 1.2                               # width to height of axes with equal scales
TITLE, LABEL, TICK, SMALL = 11, 10, 9, 8  # points
EM = 0.62                                 # a letter's width to its size, about
DOTS = 160                                # of a PNG, per inch
CROWDED = 250                             # turns from which a line is drawn thin and solid
RC = {"text.parse_math": False, "text.usetex": False, "svg.hashsalt": "vibcli", "svg.fonttype": "path",
      "pdf.fonttype": 3, "axes.unicode_minus": True, "axes.formatter.useoffset": False,
      "axes.formatter.limits": (-5, 6), "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
      "axes.axisbelow": True, "grid.color": LIGHT, "grid.linewidth": 0.7, "figure.titlesize": TITLE,
      "axes.labelsize": LABEL, "xtick.labelsize": TICK, "ytick.labelsize": TICK, "legend.fontsize": TICK,
      "legend.frameon": False, "legend.handlelength": 2.6, "legend.columnspacing": 1.5, "legend.borderaxespad": 0,
      "legend.borderpad": 0.2,
      "figure.constrained_layout.h_pad": 0.06, "figure.constrained_layout.w_pad": 0.06}
