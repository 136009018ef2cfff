"""A scene as a figure: primitives in points, made element by element, and the canvases that show them."""
