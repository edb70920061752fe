"""The library of clips: figures, previews; needs no Blender."""
