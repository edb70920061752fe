"""The Python module as its stubs describe it; needs no Blender."""
