"""What does not hold of a suite: where, by which clause, and what. Clause: ORCL-SUITE-4."""

from msgspec import Struct

from clers.conventions.clause import Clause


class Problem(Struct, frozen=True, omit_defaults=True):
    """One thing that does not hold; `case` is empty where no case is to blame. ORCL-SUITE-4."""

    file: str
    what: str
    clause: Clause
    case: str = ""

    def line(self) -> str:
        """File, case and clause in one line. Clause: ORCL-SUITE-4."""
        case = f" {self.case}:" if self.case else ""
        return f"{self.file}:{case} {self.what} [{self.clause}]"
