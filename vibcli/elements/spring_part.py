"""Parts of springs."""

from vibcli.elements.series import part_element
from vibcli.language.named_elements import Lazy

ELEMENT = part_element("spring", Lazy("spring_part"), "k", "its stiffness, force per length", "N/m", "N*m")
