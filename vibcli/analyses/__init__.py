"""What is computed from the equations of motion: the words by which `find` asks for it, what each prints, and files.

Of what is found about modes the file has a function `word(modal, asked)`; ModalAnalysis.result keeps what it finds.
What is asked with particulars has its ELEMENT there: the keys by which the reader, the manual and the schema know it.
"""

FIND = {
    "equations": "energies and equations of motion, in full and for small oscillations, of members with their "
                 "frequency equation",
    "energies": "kinetic and potential energy and the dissipation function",
    "matrices": "M, C, G and K of the small oscillations, in letters and in numbers",
    "equilibrium": "the position of rest that is reached from the drawn one, or is nearest to the place that "
                   "`equilibrium:` names, and whether it is stable",
    "equilibria": "`{equilibria: all}`: all positions of equilibrium that are found within bounds, each stable or not; "
                  "it is told whether it is proved that there are no others, or that one is missing",
    "frequencies": "natural frequencies and periods of the system without its dampers",
    "modes": "mode shapes; `{modes: 5}`: frequencies and shapes of so many, `{modes: [990, 1000]}` of these, "
             "`{modes: {up_to: 2 kHz}}` of all up to there",
    "damping": "eigenvalues, damping ratios and damped frequencies, where something damps",
    "virtual_work": "the generalised forces of weights, springs and steady loads, δA = Σ Q δq",
    "accelerations": "accelerations from rest in the drawn position and the forces of ropes, links, other constraints "
                     "and supports then, as expressions; no equilibrium is needed",
    "reactions": "forces in equilibrium: of ropes, links, gears and other constraints, and of supports on bodies",
    "equivalents": "where several springs, or dampers, end at one place that moves: the perpendicular pair that "
                   "resists like them, and whether springs and dampers share their axes",
    "response": "the motion in time: where it starts, its free part, its steady state, its extremes; "
                "`{response: {of: [x, s.force], until: 2 s}}` says which signals, and until when",
    "frequency_response": "amplitude and phase over the frequency, resonances and antiresonances; "
                          "`{frequency_response: {of: [x], to: drive}}` says of what, and to which input",
    "shares": "whose energy each mode has: of each spring, the tensions and the weights in the potential energy, of "
              "each body in the kinetic energy, of each damper in what is lost; in numbers, only where it is asked for",
    "sensitivities": "what each frequency and damping ratio depends on: exact derivatives by each parameter, the shift "
                     "of the equilibrium included; in numbers, only where it is asked for",
    "estimates": "bounds of the lowest natural frequency by Rayleigh and Dunkerley beside its exact value; in numbers, "
                 "only where it is asked for",
    "ritz": "`{ritz: {shapes: [{x1: 1, x2: 2}]}}`: upper bounds of the lowest natural frequencies by assumed shapes, "
            "beside the exact values: Rayleigh's quotient of one shape, Ritz's method of several; in numbers",
    "backbone": "`{backbone: {of: [x], up_to: 10 cm}}`: how the frequency of free motions about the equilibrium hangs "
                "on their amplitude, exactly; in numbers",
    "expansion": "the energies by powers of the deviations from equilibrium, the deflections of springs and the "
                 "equations of motion so truncated; `{expansion: 6}` says to which order of the energies, else the "
                 "fourth",
}
ANALYSES = {        # file, what a mapping with particulars says, how it is written where the word alone says too little
    "response": ("transient/response", "which signals of the motion in time, and until when", None),
    "frequency_response": ("frequency_response/frequency_response",
                           "frequency responses of which signals, to which input", None),
    "shares": ("modal/energy_shares", None, None),
    "sensitivities": ("modal/sensitivities", None, None),
    "estimates": ("modal/estimates", None, None),
    "ritz": ("modal/ritz", "bounds of the lowest natural frequencies by assumed shapes",
             "{ritz: {shapes: [{x1: 1, x2: 2}]}}"),
    "backbone": ("nonlinear/backbone", "how the frequency of free motions hangs on the amplitude of a signal",
                 "{backbone: {of: [x], up_to: 10 cm}}"),
    "expansion": ("nonlinear/expansion", "to which order of the energies the scene is expanded", None),
}
OF_MODES = tuple(word for word, row in ANALYSES.items() if row[0].startswith("modal/"))
