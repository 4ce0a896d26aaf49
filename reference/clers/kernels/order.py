"""Into the order of creation: corners and vertices renumbered. All numbers are of these."""

from librt.vecs import vec
from mypy_extensions import i64

from clers.kernels.flat import zeros


class Renumbered:
    """A corner table in the order of creation. Clause: GEOM-ORDER-3.

    `tips[f]` is the old corner that becomes corner 3f, `order[k]` the old vertex that becomes k.
    """

    def __init__(
        self, vertex: vec[i64], opposite: vec[i64], tips: vec[i64], order: vec[i64]
    ) -> None:
        corners: i64 = len(vertex)
        number = zeros(len(order))
        k: i64 = 0
        while k < len(order):
            number[order[k]] = k
            k += 1
        self.vertex = zeros(corners)
        self.opposite = zeros(corners)
        corner = zeros(corners)
        f: i64 = 0
        while 3 * f < corners:
            a: i64 = tips[f]
            b: i64 = a - 2 if a % 3 == 2 else a + 1
            c: i64 = a + 2 if a % 3 == 0 else a - 1
            corner[a] = 3 * f
            corner[b] = 3 * f + 1
            corner[c] = 3 * f + 2
            self.vertex[3 * f] = number[vertex[a]]
            self.vertex[3 * f + 1] = number[vertex[b]]
            self.vertex[3 * f + 2] = number[vertex[c]]
            f += 1
        old: i64 = 0
        while old < corners:
            across: i64 = opposite[old]
            self.opposite[corner[old]] = across if across < 0 else corner[across]
            old += 1
