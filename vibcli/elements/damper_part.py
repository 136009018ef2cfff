"""Parts of dampers."""

from vibcli.elements.series import part_element
from vibcli.language.named_elements import Lazy

ELEMENT = part_element("damper", Lazy("damper_part"), "c", "its coefficient, force per speed", "N*s/m", "N*m*s")
