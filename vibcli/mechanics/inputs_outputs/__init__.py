"""What drives small oscillations and what is read off them."""
