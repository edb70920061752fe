"""The packaged extension in an empty Blender."""
