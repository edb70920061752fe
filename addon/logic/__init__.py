"""Decisions as plain Python: values in, values out. Nothing here imports bpy."""
