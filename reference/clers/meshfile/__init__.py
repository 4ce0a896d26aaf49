"""Mesh files: PLY, OFF, OBJ and STL, read without repair and written whole or not at all."""

from clers.meshfile.mesh import RawMesh
from clers.meshfile.reading import read
from clers.meshfile.writing import write

__all__ = ["RawMesh", "read", "write"]
