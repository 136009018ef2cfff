"""Natural frequencies, damping, mode shapes, stability, and what is read off them."""
