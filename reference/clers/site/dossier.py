"""Who cites a clause, by kind: what its own page lists. Clause: TOOL-SITE-4."""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from clers.conventions.law import AnyLaw
from clers.site.headings import Heading, around
from clers.specification.citation import Citation, Kind
from clers.specification.clause_text import ClauseText
from clers.specification.repository import Repository
from clers.specification.theorems import Theorem, is_note, theorems

ERRATA: Final = "spec/errata.md"
PARTS: Final = ("code", "laws", "tests", "vectors", "proofs", "errata")


@dataclass(frozen=True, slots=True)
class Told:
    """A law as the site tells it: its words (none if only its name is known), and where it is."""

    name: str
    clause: str
    statement: str
    domain: str
    meaning: str
    path: str
    line: int


@dataclass(frozen=True, slots=True)
class Vectors:
    """The cases of one profile and operation, by their ids."""

    profile: str
    op: str
    cases: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Passage:
    """A section of a page that names the clause."""

    path: str
    anchor: str
    title: str


@dataclass(frozen=True, slots=True)
class Dossier:
    """A clause with all that cites it, each part in order of file and line."""

    clause: ClauseText
    code: tuple[Citation, ...]
    laws: tuple[Told, ...]
    tests: tuple[Citation, ...]
    vectors: tuple[Vectors, ...]
    theorems: tuple[Theorem, ...]
    proofs: tuple[Passage, ...]
    errata: tuple[Passage, ...]
    prose: tuple[Passage, ...]

    @property
    def counts(self) -> Mapping[str, int]:
        """How many each part has, in the order of the line beneath the clause."""
        numbers = (
            len(self.code),
            len(self.laws),
            len(self.tests),
            sum(len(some.cases) for some in self.vectors),
            len(self.theorems) + len(self.proofs),
            len(self.errata),
        )
        return dict(zip(PARTS, numbers, strict=True))


def told(of: Repository, registry: Sequence[AnyLaw]) -> tuple[Told, ...]:
    """Every law of the registry; without one, every law that the code writes out by its name."""
    spans = {law.name: (module.path, law.first) for module in of.modules for law in module.laws}
    cited: dict[str, tuple[str, int]] = {}
    owner: dict[str, str] = {}
    for site in of.citations:
        if site.kind is Kind.LAW:
            cited.setdefault(site.clause, (site.path, site.line))
            owner.setdefault(site.inside, site.clause)
    if not registry:
        return tuple(
            Told(name, owner.get(name, ""), "", "", "", *place) for name, place in spans.items()
        )
    return tuple(
        Told(
            law.name,
            str(law.clause),
            law.statement,
            law.domain,
            law.meaning,
            *spans.get(law.name, cited.get(str(law.clause), ("", 0))),
        )
        for law in registry
    )


def dossiers(
    of: Repository,
    laws: Iterable[Told],
    vectors: Mapping[str, tuple[Vectors, ...]],
    titles: Mapping[str, Sequence[Heading]],
) -> tuple[Dossier, ...]:
    """The dossier of every clause, in the order of the chapters."""
    sites: defaultdict[tuple[str, Kind], list[Citation]] = defaultdict(list)
    for site in of.citations:
        sites[site.clause, site.kind].append(site)
    of_law: defaultdict[str, list[Told]] = defaultdict(list)
    for law in laws:
        of_law[law.clause].append(law)
    proved: defaultdict[str, list[Theorem]] = defaultdict(list)
    for page in of.pages:
        for theorem in theorems(page) if is_note(page.path) else ():
            if isinstance(theorem, Theorem):
                for id_ in theorem.clauses:
                    proved[id_].append(theorem)
    made = list[Dossier]()
    for clause in of.clauses:
        prose = [site for site in sites[clause.clause, Kind.PROSE] if site.path.endswith(".md")]
        notes = [site for site in sites[clause.clause, Kind.NOTE] if is_note(site.path)]
        errata = [site for site in prose if site.path == ERRATA]
        made.append(
            Dossier(
                clause,
                tuple(sites[clause.clause, Kind.CODE]),
                tuple(of_law[clause.clause]),
                tuple(sites[clause.clause, Kind.TEST]),
                vectors.get(clause.clause, ()),
                tuple(proved[clause.clause]),
                _besides(_passages(notes, titles), proved[clause.clause]),
                _passages(errata, titles),
                _passages((site for site in prose if site.path != ERRATA), titles),
            )
        )
    return tuple(made)


def _besides(found: tuple[Passage, ...], proved: list[Theorem]) -> tuple[Passage, ...]:
    """The sections of notes that name a clause and are not those of its theorems."""
    own = {(theorem.path, theorem.anchor) for theorem in proved}
    return tuple(passage for passage in found if (passage.path, passage.anchor) not in own)


def _passages(
    sites: Iterable[Citation], titles: Mapping[str, Sequence[Heading]]
) -> tuple[Passage, ...]:
    """The sections around some places, each once."""
    found = (
        (site.path, around(titles.get(site.path, ()), site.line))
        for site in sites
        if site.path in titles
    )
    return tuple(
        dict.fromkeys(
            Passage(path, heading.anchor if heading else "", heading.title if heading else path)
            for path, heading in found
        )
    )
