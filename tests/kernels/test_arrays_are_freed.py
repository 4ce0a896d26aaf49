"""What kernels were given and gave back is freed with the last who holds it, in both builds."""

import gc
import tracemalloc

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface_of_indices
from clers.container import file
from clers.container.options import Exact, Options
from clers.generate.flat_families import torus_chain, with_holes
from clers.geometry.positions import Precision, positions
from clers.measure.path import must

FACES = 2000


def there_and_back() -> None:
    """A mesh with handles and curves, with positions and without, by each code that takes it."""
    given = with_holes(torus_chain(FACES // 100, 7, 7), FACES // 100)
    surface = must(surface_of_indices(given))
    places = must(
        positions(Precision.F32, [float(i % 64) for i in range(3 * given.vertices)], given.vertices)
    )
    for code in (CodeName.GOLDEN, CodeName.BEST, CodeName.CONTEXT):
        data = must(file.encode(surface, None, Options(code)))
        assert must(file.decode(data)).surface.faces == given.faces
    data = must(file.encode(surface, places, Options(CodeName.GOLDEN, Exact())))
    assert must(file.decode(data)).surface.faces == given.faces


def test_arrays_are_freed() -> None:
    """TOOL-BUILD-6: three more rounds leave no array, which has a number for each face."""
    there_and_back()
    tracemalloc.start()
    try:
        there_and_back()
        gc.collect()
        before, _ = tracemalloc.get_traced_memory()
        for _ in range(3):
            there_and_back()
        gc.collect()
        after, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert after - before < 3 * 8 * FACES
