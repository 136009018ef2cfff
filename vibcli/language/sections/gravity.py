"""Gravity: V = −m (gₓ x + g_y y) for every body that has a place."""

from vibcli.language.kinds import OneOf, Quantity, vector

KIND = OneOf("an acceleration, or a vector [gx, gy]", scalar=Quantity("m/s^2"),
             sequence=vector("m/s^2", "an acceleration [gx, gy]"))
ABOUT = ("The acceleration of gravity, downwards (along −y), or a vector. Without it nothing has weight; bodies "
         "without a place have none in any case.")

