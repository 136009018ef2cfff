"""The expansion of a scene about its equilibrium: to which order."""

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import WholeNumber

ELEMENT = Element(
    "expansion",
    "The energies collected by powers of the deviations from equilibrium and the rates, up to an order; the "
    "deflections of the springs and the equations of motion to one order less; of the energy of each spring what its "
    "material makes, were its deflection of the first order alone, and what its geometry adds. In letters where the "
    "equilibrium is known in letters, and in numbers. Dampers and loads in time are left out.",
    {"order": Field(WholeNumber(8, 2), "of the energies; 4 if left out")},
    short="order",
    example="expanded_about_rest",
)
