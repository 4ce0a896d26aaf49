"""Where JSON values part. Clauses: ORCL-DIVERGE-10, ORCL-JUDGE-2."""

from clers.conformance.judging.judged import Divergence


def of_value(right: object, got: object) -> Divergence | None:
    """The first place, depth first, by a JSON pointer; numbers are equal by value.

    Clauses: ORCL-DIVERGE-10, ORCL-OP-1.
    """
    rest: list[tuple[str, object, object]] = [("", right, got)]
    while rest:
        path, one, other = rest.pop()
        if isinstance(one, dict) and isinstance(other, dict):
            if set(one) != set(other):
                return _at(path, sorted(one), sorted(other))
            inside = [(f"{path}/{_escaped(key)}", one[key], other[key]) for key in one]
            rest += reversed(inside)
        elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
            pairs = enumerate(zip(one, other, strict=True))
            rest += reversed([(f"{path}/{i}", a, b) for i, (a, b) in pairs])
        elif isinstance(one, bool) is not isinstance(other, bool) or one != other:
            return _at(path, one, other)
    return None


def _at(path: str, one: object, other: object) -> Divergence:
    place = f"the value at {path}" if path else "the whole value"
    return Divergence(kind="value", place=place, expected=repr(one), got=repr(other))


def _escaped(key: str) -> str:
    """A key within a JSON pointer (RFC 6901)."""
    return key.replace("~", "~0").replace("/", "~1")
