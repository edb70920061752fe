"""Clips drawn over a 3D View: the grid of stills, the stage where clips play, and what the mouse and keys do there.

Only `canvas` and `textures` speak to the graphics card. Everything else computes places, shapes and colors.
"""
