"""The colours of roles: ink for what is there, blue for coordinates, red for loads, green for what is driven."""

COLOURS = {
    "ink": "#1b1b1b", "body": "#dce4ec", "inner": "#c9d5e1", "fixed": "#e4e4e0", "paper": "#ffffff",
    "ground": "#4d4d4d", "spring": "#1b1b1b", "damper": "#1b1b1b", "oil": "#e8e8e8", "rope": "#7b4a1e",
    "belt": "#7b4a1e", "coordinate": "#1d5fa6", "load": "#b3261e", "driven": "#2c7a4b", "measure": "#6a6a6a",
    "ghost": "#b9b9b9", "note": "#5a5a5a",
}
