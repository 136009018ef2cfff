"""From the bytes of a scene file to a tree of nodes with places."""
