"""Laws of models: what every one keeps to, and what static, adaptive and context models do."""

from itertools import accumulate, pairwise
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtSymbol
from clers.information.adaptive import Adaptive, adaptive, recount
from clers.information.automaton import start
from clers.information.given import (
    ANY_ADAPTIVE,
    ANY_AUTOMATON,
    ANY_MESSAGE,
    ANY_TABLE,
    LEARNING,
    MESSAGE,
    TABLE,
    AdaptiveRequest,
    AutomatonRequest,
    Learning,
    Message,
    Table,
)
from clers.information.model import MAXIMUM_TOTAL, Slot, differences, has_ended, slots
from clers.information.static import static, uniform


def _tables_are_cumulative(given: Message) -> Verdict:
    """Clauses: INFO-MODEL-1, INFO-MODEL-2."""
    here = given.model
    verdicts: list[Verdict] = []
    for symbol in (*given.symbols, -1):
        table = here.cumulative
        rises = all(below <= upto for below, upto in pairwise(table[:64]))
        verdicts.append(same((0, True, True), (table[0], rises, table[-1] <= MAXIMUM_TOTAL)))
        if symbol >= 0:
            here = here.after(symbol)
    return every(*verdicts)


def _same_past_same_tables(given: Message) -> Verdict:
    """Clause: INFO-MODEL-4."""
    whole = slots(given.model, given.symbols)
    if isinstance(whole, Rejected):
        return Fails("slots", repr(whole), WHOLE)
    half = len(given.symbols) // 2
    return every(
        same(whole, slots(given.model, given.symbols)),
        same(Accepted(whole.value[:half]), slots(given.model, given.symbols[:half])),
    )


def _nothing_after_the_end(given: Message) -> Verdict:
    """Clause: INFO-MODEL-3."""
    here = given.model
    for index, symbol in enumerate(given.symbols):
        if has_ended(here):
            return Fails("an open model", "an ended one", AtSymbol(index))
        here = here.after(symbol)
    if not has_ended(here):
        return Holds()
    longer = slots(given.model, (*given.symbols, 0))
    return same(True, isinstance(longer, Rejected) and longer.reason == Reason.NOT_IN_ALPHABET)


def _first_fault_is_named(given: Message) -> Verdict:
    """Clauses: INFO-MODEL-5, INFO-MODEL-6."""
    found = slots(given.model, given.symbols)
    here = given.model
    for index, symbol in enumerate(given.symbols):
        table = here.cumulative
        if table[-1] > 2**30:
            return _rejected(found, Clause.INFO_MODEL_6, index)
        if symbol < 0 or len(set(table[symbol : symbol + 2])) < 2:
            return _rejected(found, Clause.INFO_MODEL_5, index)
        here = here.after(symbol)
    return same(True, isinstance(found, Accepted) and len(found.value) == len(given.symbols))


def _rejected(found: Accepted[tuple[Slot, ...]] | Rejected, clause: Clause, index: int) -> Verdict:
    """It is rejected by this clause, at this symbol."""
    if isinstance(found, Accepted):
        return Fails(f"rejected by {clause}", "accepted", AtSymbol(index))
    return same((clause, AtSymbol(index)), (found.clause, found.where))


def _static_never_changes(given: Table) -> Verdict:
    """Clause: INFO-STATIC-1."""
    model = static(given.frequencies)
    if isinstance(model, Rejected):
        return Fails("a model", repr(model), WHOLE)
    symbol = max(range(len(given.frequencies)), key=lambda s: given.frequencies[s])
    return every(
        same((0, *accumulate(given.frequencies)), model.value.cumulative),
        same(model.value, model.value.after(symbol)),
    )


def _uniform_is_all_ones(given: Table) -> Verdict:
    """Clause: INFO-STATIC-2."""
    size = len(given.frequencies)
    even, ones = uniform(size), static((1,) * size)
    if isinstance(even, Rejected) or isinstance(ones, Rejected):
        return Fails("models", f"{even}, {ones}", WHOLE)
    return same(tuple(ones.value.cumulative), tuple(even.value.cumulative))


def _bad_tables_are_rejected(given: Table) -> Verdict:
    """Clause: INFO-STATIC-3."""
    negative = [symbol for symbol, f in enumerate(given.frequencies) if f < 0]
    good = not negative and 1 <= sum(given.frequencies) <= 2**30
    got = static(given.frequencies)
    if isinstance(got, Accepted):
        return same(good, True)
    where = AtSymbol(negative[0]) if negative else WHOLE
    return same((False, Reason.BAD_TABLE, where), (good, got.reason, got.where))


def _bad_adaptives_are_rejected(given: AdaptiveRequest) -> Verdict:
    """Clause: INFO-ADAPT-3."""
    table = static(given.frequencies)
    least = max(sum(given.frequencies), given.increment + len(given.frequencies))
    good = given.increment >= 1 and least <= given.limit <= 2**30
    got = adaptive(given.frequencies, given.increment, given.limit)
    match table, got:
        case Rejected(), _:
            return same(table, got)
        case _, Accepted(model):
            return same((good, given.frequencies), (True, differences(model.cumulative)))
        case _, Rejected(reason, clause):
            return same((False, Reason.BAD_TABLE, Clause.INFO_ADAPT_3), (good, reason, clause))


def _learn(given: Learning) -> tuple[Adaptive, ...]:
    """The model at the start and after each symbol."""
    return tuple(accumulate(given.history, lambda m, s: m.after(s), initial=given.start))


def _adaptive_is_a_recount(given: Learning) -> Verdict:
    """Clauses: INFO-ADAPT-1, INFO-ADAPT-2."""
    last = _learn(given)[-1]
    return same(recount(given.start, given.history), differences(last.cumulative))


def _adaptive_keeps_its_limit(given: Learning) -> Verdict:
    """Clauses: INFO-ADAPT-2, INFO-ADAPT-3."""
    kept = [f > 0 for f in differences(given.start.cumulative)]
    verdicts: list[Verdict] = []
    for model in _learn(given):
        verdicts.append(same(True, model.cumulative[-1] <= given.start.limit))
        verdicts.append(same(kept, [f > 0 for f in differences(model.cumulative)]))
    return every(*verdicts)


def _bad_automata_are_rejected(given: AutomatonRequest) -> Verdict:
    """Clause: INFO-AUTOMATON-2."""
    tables, rows = given.automaton.frequencies, given.automaton.successors
    size = len(tables)
    good = (
        len(rows) == size
        and given.number in range(size)
        and all(isinstance(static(table), Accepted) for table in tables)
        and all(len(table) == len(row) for table, row in zip(tables, rows, strict=True))
        and all(
            q in range(size)
            for table, row in zip(tables, rows, strict=True)
            for f, q in zip(table, row, strict=True)
            if f > 0
        )
    )
    got = start(given.automaton, given.number)
    if isinstance(got, Accepted):
        return same((good, tables[given.number]), (True, differences(got.value.cumulative)))
    return same((good, Reason.BAD_TABLE), (False, got.reason))


def _automaton_follows_its_successors(given: AutomatonRequest) -> Verdict:
    """Clause: INFO-AUTOMATON-1."""
    got = start(given.automaton, given.number)
    if isinstance(got, Rejected):
        return Holds()
    here, number = got.value, given.number
    verdicts: list[Verdict] = []
    for turn in range(8):
        table = given.automaton.frequencies[number]
        verdicts.append(same((number, table), (here.number, differences(here.cumulative))))
        allowed = [symbol for symbol, f in enumerate(table) if f > 0]
        symbol = allowed[turn % len(allowed)]
        here, number = here.after(symbol), given.automaton.successors[number][symbol]
    return every(*verdicts)


LAWS_OF_MODELS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "tables-are-cumulative",
        Clause.INFO_MODEL_1,
        "each table a message meets starts at 0, never falls, ends at 2^30 at most",
        MESSAGE,
        _tables_are_cumulative,
    ),
    Law(
        "nothing-after-the-end",
        Clause.INFO_MODEL_3,
        "a model has not ended before the last symbol, and an ended one allows no more",
        MESSAGE,
        _nothing_after_the_end,
    ),
    Law(
        "same-past-same-tables",
        Clause.INFO_MODEL_4,
        "the tables met depend on the symbols before and on nothing else",
        MESSAGE,
        _same_past_same_tables,
    ),
    Law(
        "first-fault-is-named",
        Clause.INFO_MODEL_5,
        "a message is rejected at its first symbol without a slot, and only then",
        ANY_MESSAGE,
        _first_fault_is_named,
    ),
    Law(
        "static-never-changes",
        Clause.INFO_STATIC_1,
        "a static model has the same table after every symbol",
        TABLE,
        _static_never_changes,
    ),
    Law(
        "uniform-is-all-ones",
        Clause.INFO_STATIC_2,
        "the uniform model of n symbols is the static model of n ones",
        TABLE,
        _uniform_is_all_ones,
    ),
    Law(
        "bad-tables-are-rejected",
        Clause.INFO_STATIC_3,
        "a table is accepted exactly if none is negative and the total is 1 to 2^30",
        ANY_TABLE,
        _bad_tables_are_rejected,
    ),
    Law(
        "automaton-follows-its-successors",
        Clause.INFO_AUTOMATON_1,
        "each symbol leads to the context that the successors say, with its table",
        ANY_AUTOMATON,
        _automaton_follows_its_successors,
    ),
    Law(
        "bad-automata-are-rejected",
        Clause.INFO_AUTOMATON_2,
        "an automaton is accepted exactly if its tables and successors are good",
        ANY_AUTOMATON,
        _bad_automata_are_rejected,
    ),
    Law(
        "adaptive-is-a-recount",
        Clause.INFO_ADAPT_1,
        "the table after a history is that of counting the history",
        LEARNING,
        _adaptive_is_a_recount,
    ),
    Law(
        "adaptive-keeps-its-limit",
        Clause.INFO_ADAPT_2,
        "no total is over the limit, no positive frequency vanishes, no 0 becomes positive",
        LEARNING,
        _adaptive_keeps_its_limit,
    ),
    Law(
        "bad-adaptives-are-rejected",
        Clause.INFO_ADAPT_3,
        "an adaptive model is accepted exactly if table, increment and limit are good",
        ANY_ADAPTIVE,
        _bad_adaptives_are_rejected,
    ),
)
