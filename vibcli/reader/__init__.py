"""A document becomes a Spec: names, dimensions, what is asked."""
