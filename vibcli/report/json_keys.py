"""The keys of --json: what each means. Dots lead into objects, [] into lists."""

ABOUT = ("What `vibcli solve`, `frequencies` and `equations` print with --json: one object in SI units, angles in "
         "radians, null where there is nothing. Values are strings where the scene has symbols without value "
         "(expressions of the scene language) or with --digits (decimals); else numbers.")
KEYS = {
    "title": "the title of the scene, or null",
    "coordinates": "names of the generalised coordinates, in the order of all rows and columns",
    "chosen": "only where the scene chooses: a list, one entry to each chosen parameter",
    "chosen[].parameter": "its name",
    "chosen[].condition": "the condition as written",
    "chosen[].values": "its value in each solution, ascending; all else is of the first",
    "chosen[].closed_forms": "the same as expressions of the language of scenes, null where none was found",
    "chosen[].residuals": "what is left of the conditions after substitution, relative to their terms",
    "equilibrium": "the equilibrium reached from the drawn position",
    "equilibrium.coordinates": "{name: value}",
    "equilibrium.dependent": "{name: value} of the coordinates that constraints tie to the others, as functions of "
                             "them where symbols have no value",
    "equilibrium.stable": "true or false (motion that costs no energy counts as stable); null where symbols leave it "
                          "open",
    "equilibrium.residual": "what is left of the forces, relative to the sum of the magnitudes of their terms",
    "energies": "as expressions of the language of scenes, in solve and equations",
    "energies.T": "kinetic energy",
    "energies.V": "potential energy, without constants",
    "energies.Phi": "dissipation function; 0 where nothing damps",
    "equations": "a list, one entry to each coordinate",
    "equations[].coordinate": "the coordinate",
    "equations[].text": "the full equation of motion in the language of scenes; null where there is none",
    "equations[].latex": "the same in LaTeX",
    "equations[].linear_text": "the equation of small oscillations, the coordinates counted from equilibrium",
    "equations[].linear_latex": "the same in LaTeX",
    "matrices": "of M q'' + (C + G) q' + K q = 0: lists of rows, null where absent",
    "matrices.M": "mass matrix",
    "matrices.C": "damping matrix, symmetric",
    "matrices.G": "gyroscopic matrix, skew",
    "matrices.K": "stiffness matrix",
    "reactions": "{signal: force or moment in equilibrium}, with `find: [reactions]`; null where statics leaves it "
                 "open",
    "modes": "a list: modes of the system without its dampers, by ascending omega, unstable ones first",
    "modes[].index": "number of the mode, from 1",
    "modes[].omega": "natural angular frequency; exactly 0 of a rigid mode, null of one that grows without "
                     "oscillating",
    "modes[].frequency": "omega/(2 pi), in Hz",
    "modes[].period": "2 pi/omega; null of a rigid mode and where omega is null",
    "modes[].growth_rate": "of an unstable mode, which grows as exp(growth_rate t), oscillating where omega is given "
                           "too (flutter); negative of one that decays where there is G and K is not symmetric; else "
                           "null",
    "modes[].shape": "{coordinate: amplitude}, the first one that moves being 1 (see --normalise)",
    "modes[].error": "bound of the relative error of omega and of growth_rate",
    "damped": "a list by ascending |eigenvalue|, one entry to a conjugate pair; null where nothing damps",
    "damped[].index": "number of the mode, from 1; two real eigenvalues of one over-damped mode share it",
    "damped[].eigenvalue": "[re, im] of the eigenvalue, im ≥ 0: motion as exp(eigenvalue t)",
    "damped[].omega": "|eigenvalue|; √(λ₁λ₂) of an over-damped mode",
    "damped[].zeta": "damping ratio −re/|eigenvalue|; −(λ₁ + λ₂)/(2 omega) ≥ 1 of an over-damped mode; null of an "
                     "unpaired real eigenvalue",
    "damped[].omega_d": "damped angular frequency |im|; null where it does not oscillate",
    "damped[].decay": "decay rate −re",
    "damped[].growth_rate": "growth rate re where it grows; else null",
    "damped[].shape": "{coordinate: amplitude}, a number or [re, im]",
    "damped[].error": "bound of the relative error of the eigenvalue",
    "insight": "only where `find` or --insight asks for it",
    "insight.shares": "whose energy each mode has, in fractions of one; negative those of what lowers the stiffness",
    "insight.shares.modes": "a list, one entry to each mode",
    "insight.shares.modes[].index": "number of the mode",
    "insight.shares.modes[].potential": "{name of a spring, `tension of` it, `the weights` or `written out`: share}; "
                                        "empty of a rigid mode",
    "insight.shares.modes[].kinetic": "{name of a body, or `written out`: share}",
    "insight.shares.damped": "a list, one entry to each eigenvalue; null where nothing damps",
    "insight.shares.damped[].index": "number of the damped mode",
    "insight.shares.damped[].dissipation": "{name of a damper: its share of the energy that is lost}",
    "insight.sensitivities": "exact derivatives by the parameters that no others define, the shift of the equilibrium "
                             "included",
    "insight.sensitivities.parameters": "a list, one entry to each parameter",
    "insight.sensitivities.parameters[].parameter": "its name",
    "insight.sensitivities.parameters[].value": "its value p",
    "insight.sensitivities.parameters[].modes": "a list, one entry to each mode that oscillates",
    "insight.sensitivities.parameters[].modes[].index": "number of the mode",
    "insight.sensitivities.parameters[].modes[].omega": "derivative of omega by p; null of "
                                                         "gyroscopic modes that coincide",
    "insight.sensitivities.parameters[].modes[].logarithmic": "that derivative times p/omega",
    "insight.sensitivities.parameters[].damped": "a list, one entry to each simple eigenvalue; null where nothing "
                                                 "damps",
    "insight.sensitivities.parameters[].damped[].index": "number of the damped mode",
    "insight.sensitivities.parameters[].damped[].eigenvalue": "[re, im] of the derivative of the eigenvalue by p",
    "insight.sensitivities.parameters[].damped[].zeta": "derivative of zeta by p; null where there is no zeta",
    "insight.sensitivities.parameters[].refusal": "why there is no derivative by p, or null",
    "insight.sensitivities.coinciding": "lists of the modes whose frequencies coincide: their derivatives are those of "
                                        "the frequencies in ascending order as p grows",
    "insight.sensitivities.refusal": "why there are none of the damped modes, or null",
    "insight.estimates": "of the lowest natural frequency; null each where the bounds do not hold",
    "insight.estimates.omega": "its exact value",
    "insight.estimates.rayleigh": "Rayleigh's quotient of the static deflection, an upper bound of omega",
    "insight.estimates.dunkerley": "Dunkerley's lower bound of omega",
    "insight.estimates.deflection": "{coordinate: static deflection}, the largest being 1",
    "insight.estimates.alone": "{name of a body: omega with its inertia alone}, from which Dunkerley's bound is made",
    "insight.estimates.refusal": "why the bounds do not hold, or null",
    "characteristic_polynomial": "in letters only: factors in λ = omega² that have no readable roots",
    "cases": "{name: the same keys}, where the file has cases",
}
