"""Parts of dampers."""

from vibcli.elements.series import part_element

ELEMENT = part_element("damper", "c", "its coefficient, force per speed", "N*s/m", "N*m*s")
