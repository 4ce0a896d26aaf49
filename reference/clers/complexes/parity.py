"""Sets that grow together, each element the same way up as its set or the other: union-find."""


class Parity:
    """The elements 0 … n−1, at first each a set of its own. A tool local to one function's work.

    Each set is led by its lowest element. Two-pass find with path compression: n elements and m
    unions take O((n + m) log n) at most, and in practice linear time.
    """

    __slots__ = ("_lead", "_odd")

    def __init__(self, n: int) -> None:
        self._lead = list(range(n))
        self._odd = [False] * n  # the other way up than `_lead`

    def find(self, element: int) -> tuple[int, bool]:
        """The lowest element of the set, and whether this one is the other way up."""
        lead, odd = self._lead, self._odd
        path: list[int] = []
        while lead[element] != element:
            path.append(element)
            element = lead[element]
        turned = False
        for x in reversed(path):
            turned ^= odd[x]
            lead[x], odd[x] = element, turned
        return element, turned

    def unite(self, a: int, b: int, *, differ: bool) -> bool:
        """Join two sets so that a and b are the same way up, or differ. False if they cannot."""
        lead_a, odd_a = self.find(a)
        lead_b, odd_b = self.find(b)
        if lead_a == lead_b:
            return odd_a ^ odd_b == differ
        low, high = min(lead_a, lead_b), max(lead_a, lead_b)
        self._lead[high] = low
        self._odd[high] = odd_a ^ odd_b ^ differ
        return True
