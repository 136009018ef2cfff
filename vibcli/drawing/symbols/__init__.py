"""How each thing of a scene looks; of what joins two ends, by the name of the element, the file that draws it."""

SYMBOLS = {
    "damper": ("damper", "a dashpot, a pad on a plate where friction is dry, also along an arc about a joint"),
    "inerter": ("inerter", "a rack that turns a flywheel, also along an arc about a joint"),
    "spring": ("spring", "a zigzag, an elastic shaft, a spiral about a joint"),
}
