"""A folder beside its manifest: which files it has, and their bytes. Clause: ORCL-SUITE-4."""

from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

import msgspec
from msgspec import UNSET

from clers.conventions.clause import Clause
from clers.conventions.result import Rejected
from clers.oracle.suite.files import CANARIES, FLAGS, MANIFEST, RETIRED, Suite, read_bytes
from clers.oracle.suite.problem import Problem
from clers.oracle.suite.rendered import parts_of, suite_files
from clers.oracle.suite.written import present

MADE = frozenset((FLAGS, RETIRED, CANARIES))
"""Those of the manifest's others whose bytes follow from what they say."""


def of_folder(folder: Path, suite: Suite) -> Iterator[Problem]:
    """Files that are missing, too many, changed or otherwise written.

    Clauses: ORCL-SUITE-1, ORCL-SUITE-2.
    """
    manifest = suite.manifest
    digests = {entry.path: entry.sha256 for entry in manifest.files}
    digests.update((entry.path, entry.sha256) for entry in manifest.others)
    others: dict[str, bytes] = {}
    for path, digest in digests.items():
        data = read_bytes(folder, path)
        if isinstance(data, Rejected):
            yield Problem(path, data.detail.partition(": ")[2], Clause.ORCL_SUITE_2)
            continue
        if sha256(data.value).hexdigest() != digest:
            yield Problem(path, "its SHA-256 is not the manifest's", Clause.ORCL_SUITE_2)
        others[path] = data.value
    for path in present(folder):
        if path != MANIFEST and path not in digests:
            yield Problem(path, "the manifest does not have it", Clause.ORCL_SUITE_2)
    yield from _written(folder, suite, others)


def _written(folder: Path, suite: Suite, found: dict[str, bytes]) -> Iterator[Problem]:
    """Is every byte as this suite is written?"""
    right = suite_files(
        parts_of((part.profile, case) for part in suite.parts for case in part.cases),
        suite.flags,
        suite.retired,
        suite.canaries,
        {entry.path: found.get(entry.path, b"") for entry in suite.manifest.others
         if entry.path not in MADE},
        suite.manifest.mutation,
    )  # fmt: skip
    for path in (*(entry.path for entry in suite.manifest.files), *sorted(MADE)):
        if path not in right:
            what = "it has another profile or operation than its name says"
            yield Problem(path, what, Clause.ORCL_SUITE_1)
        elif path in found and right[path] != found[path]:
            yield Problem(path, "it is written in another way", Clause.ORCL_SUITE_1)
    again = msgspec.json.decode(right[MANIFEST], type=type(suite.manifest))
    for key in ("spec", "suite", "count", "profiles", "files", "others"):
        said, counted = getattr(suite.manifest, key), getattr(again, key)
        if said != counted:
            name = "cases" if key == "count" else key
            yield Problem(MANIFEST, f"{name} is not so", Clause.ORCL_SUITE_2)
    if suite.manifest.mutation is not UNSET:
        score = suite.manifest.mutation
        if not 0 <= score.killed <= score.mutants:
            yield Problem(MANIFEST, "mutation is not so", Clause.ORCL_SUITE_2)
