"""Parts of springs."""

from vibcli.elements.series import part_element

ELEMENT = part_element("spring", "k", "its stiffness, force per length", "N/m", "N*m")
