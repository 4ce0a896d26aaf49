"""What there is to fuzz of an adapter: its operations, and the laws about them. ORCL-FUZZ-1, -7."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass

from clers.conformance.messages import Caps
from clers.conformance.results import RESULTS
from clers.oracle.fuzz.checks import Asker, Check, afresh, by_reference, one_against_the_other
from clers.oracle.fuzz.codec_law import CODEC, codec_law
from clers.oracle.fuzz.inputs import Drawn, drawn
from clers.oracle.fuzz.relations import COMES_BACK, NAMES, PARTNER, comes_back, names_do_not_matter


@dataclass(frozen=True, slots=True)
class Family:
    """What is drawn and how it is judged: an operation, or a law about one.

    `share`: of the examples of an operation a law has one in so many.
    """

    name: str
    op: str
    drawn: Drawn
    check: Check
    share: int = 1
    law: str = ""


def families(of: Asker, only: Collection[str] = ()) -> tuple[Family, ...]:
    """The operations that an adapter declares, then the laws about them. ORCL-FUZZ-1, -7."""
    ops = [name for name in RESULTS if name in of.said.ops and name != "echo"]
    chosen = [name for name in ops if not only or name in only]
    caps = of.said.caps
    asked = (_family(name, name, caps, by_reference(afresh(of))) for name in chosen)
    laws = (
        _family(f"{name} {law}", name, caps, check, law)
        for name in chosen
        for law, check in _laws(of, name)
    )
    return tuple(family for family in (*asked, *laws) if family is not None)


def _family(name: str, op: str, caps: Caps, check: Check, law: str = "") -> Family | None:
    what = drawn(op, caps)
    return None if what is None else Family(name, op, what, check, 4 if law else 1, law)


def _laws(of: Asker, name: str) -> Iterator[tuple[str, Check]]:
    """The laws of an operation whose other operations are declared too. Clause: ORCL-FUZZ-7."""
    if PARTNER.get(name) in of.said.ops:
        yield COMES_BACK, comes_back(afresh(of))
    if name == "word.encode":
        yield NAMES, names_do_not_matter(afresh(of))
    if name in ("word.encode", "word.decode") and {"word.encode", "word.decode"} <= set(
        of.said.ops
    ):
        yield CODEC, codec_law(afresh(of))


def check_of(of: Asker, op: str, law: str = "") -> Check | None:
    """The check by the reference, or by the law of this name, if there is one for the operation."""
    return dict(_laws(of, op)).get(law) if law else by_reference(of)


def opposed(first: Asker, second: Asker, only: Collection[str] = ()) -> tuple[Family, ...]:
    """What both adapters declare, one against the other. Clause: ORCL-AGAINST-1."""
    caps = narrower(first.said.caps, second.said.caps)
    ops = [name for name in RESULTS if name in first.said.ops and name in second.said.ops]
    made = (
        _family(name, name, caps, one_against_the_other(afresh(first), afresh(second)))
        for name in ops
        if name != "echo" and (not only or name in only)
    )
    return tuple(family for family in made if family is not None)


def narrower(one: Caps, other: Caps) -> Caps:
    """What both bear. Clause: ORCL-AGAINST-1."""
    few = [caps.boundaries for caps in (one, other)]
    return Caps(
        handles=one.handles and other.handles,
        boundaries="none" if "none" in few else "one" if "one" in few else "many",
        components=one.components and other.components,
        max_faces=min(one.max_faces, other.max_faces),
        max_symbols=min(one.max_symbols, other.max_symbols),
        codes=tuple(code for code in one.codes if code in other.codes),
        coders=tuple(coder for coder in one.coders if coder in other.coders),
    )
