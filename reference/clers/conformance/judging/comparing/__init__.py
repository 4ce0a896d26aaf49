"""Two meshes beside each other, whatever their names: the same, or how they differ."""
