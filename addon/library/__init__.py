"""The library of clips inside Blender: what the session shows of it, fetched in the background.

Nothing here makes data-blocks. All that is kept lies in this package, in caches with a name and a bound.
"""
