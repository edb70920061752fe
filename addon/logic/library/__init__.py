"""What the library browser decides and computes, without Blender: places, times, pages, marks and shapes."""
