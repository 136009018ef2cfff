"""The keys of --json: what each means. Dots lead into objects, [] into lists."""

ABOUT = ("What `vibcli solve`, `frequencies` and `equations` print with --json: one object in SI units, angles in "
         "radians, null where there is nothing. Values are strings where the scene has symbols without value "
         "(expressions of the scene language) or with --digits (decimals); else numbers.")
KEYS = {
    "title": "the title of the scene, or null",
    "coordinates": "names of the generalised coordinates, in the order of all rows and columns",
    "equilibrium": "the equilibrium reached from the drawn position",
    "equilibrium.coordinates": "{name: value}",
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
    "characteristic_polynomial": "in letters only: factors in λ = omega² that have no readable roots",
    "cases": "{name: the same keys}, where the file has cases",
}
