"""How each thing of a scene looks."""
