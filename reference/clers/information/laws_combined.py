"""Laws of models made of models: each part of the message costs what it costs alone."""

from fractions import Fraction
from math import prod
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.information.automaton import start
from clers.information.combined import (
    Contexts,
    Refined,
    Turns,
    Until,
    followed,
    joined,
    pieces,
    raw,
    times,
)
from clers.information.given import (
    ANY_AUTOMATON,
    NUMBER,
    SEVERAL,
    AutomatonRequest,
    Message,
    Number,
    Several,
)
from clers.information.laws_measure import along
from clers.information.measure import probability
from clers.information.model import Model, cumulative, has_ended
from clers.information.static import Static


def _costs(parts: tuple[Message, ...]) -> Accepted[Fraction]:
    """The product of what the parts cost alone."""
    chances = [probability(part.model, part.symbols) for part in parts]
    return Accepted(prod((c.value for c in chances if isinstance(c, Accepted)), start=Fraction(1)))


def _ends(model: Model, symbols: tuple[int, ...]) -> Verdict:
    """The model ends with these symbols and not before."""
    ended = [has_ended(here) for here in along(model, symbols)]
    return same([False] * len(symbols) + [True], ended)


def _automaton_is_contexts(given: AutomatonRequest) -> Verdict:
    """Clause: INFO-COMBINE-1."""
    started = start(given.automaton, given.number)
    if isinstance(started, Rejected):
        return Holds()
    tables = tuple(Static(cumulative(row)) for row in given.automaton.frequencies)
    quick: Model = started.value
    plain: Model = Contexts(tables, given.automaton.successors, given.number)
    verdicts: list[Verdict] = []
    for turn in range(8):
        table = quick.cumulative
        verdicts.append(same(table, plain.cumulative))
        allowed = [s for s in range(len(table) - 1) if table[s] < table[s + 1]]
        symbol = allowed[turn % len(allowed)]
        quick, plain = quick.after(symbol), plain.after(symbol)
    return every(*verdicts)


def _contexts_learn_apart(given: Several) -> Verdict:
    """Clause: INFO-COMBINE-1. Two contexts with a model each; odd symbols lead to the second."""
    models = tuple(part.model for part in given.parts[:2])
    widest = max(len(model.cumulative) for model in models)
    if len(models) < 2 or widest > 1 << 10:
        return Holds()
    here = Contexts(models, (tuple(s % 2 for s in range(widest)),) * 2)
    queues = [list(part.symbols) for part in given.parts[:2]]
    told: list[int] = []
    number = 0
    while queues[number]:
        told.append(queues[number].pop(0))
        number = told[-1] % 2
    used = tuple(
        Message(part.model, part.symbols[: len(part.symbols) - len(queue)])
        for part, queue in zip(given.parts, queues, strict=False)
    )
    return same(_costs(used), probability(here, told))


def _turns_deal_out(given: Several) -> Verdict:
    """Clause: INFO-COMBINE-2."""
    length = min((len(part.symbols) for part in given.parts), default=0)
    model = Turns(tuple(part.model for part in given.parts))
    dealt = tuple(part.symbols[j] for j in range(length) for part in given.parts)
    used = tuple(Message(part.model, part.symbols[:length]) for part in given.parts)
    return same(_costs(used), probability(model, dealt))


def _until_stops(given: Several) -> Verdict:
    """Clause: INFO-COMBINE-3."""
    part = given.parts[0]
    if not part.symbols:
        return Holds()
    stop = part.symbols[-1]
    symbols = part.symbols[: part.symbols.index(stop) + 1]
    model = Until(part.model, stop)
    return every(
        _ends(model, symbols),
        same(probability(part.model, symbols), probability(model, symbols)),
    )


def _times_counts(given: Several) -> Verdict:
    """Clause: INFO-COMBINE-4."""
    part = given.parts[0]
    model = times(part.model, len(part.symbols))
    return every(
        same(True, has_ended(times(part.model, 0)) and has_ended(times(part.model, -1))),
        _ends(model, part.symbols),
        same(probability(part.model, part.symbols), probability(model, part.symbols)),
    )


def _followed_goes_on(given: Several) -> Verdict:
    """Clause: INFO-COMBINE-5."""
    model: Model = times(given.parts[-1].model, len(given.parts[-1].symbols))
    symbols = given.parts[-1].symbols
    for part in reversed(given.parts[:-1]):
        model = followed(times(part.model, len(part.symbols)), model)
        symbols = part.symbols + symbols
    return every(_ends(model, symbols), same(_costs(given.parts), probability(model, symbols)))


def _refined_goes_into_detail(given: Several) -> Verdict:
    """Clause: INFO-COMBINE-6. Every symbol of the first message is followed by the last one."""
    coarse, fine = given.parts[0], given.parts[-1]
    size = max(coarse.symbols, default=0) + 1
    if size > 1 << 10:
        return Holds()
    detail = times(fine.model, len(fine.symbols))
    model = Refined(times(coarse.model, len(coarse.symbols)), (detail,) * size)
    symbols = tuple(s for c in coarse.symbols for s in (c, *fine.symbols))
    used = (coarse,) + (fine,) * len(coarse.symbols)
    return every(_ends(model, symbols), same(_costs(used), probability(model, symbols)))


def _raw_bits_cost_themselves(given: Number) -> Verdict:
    """Clause: INFO-COMBINE-7."""
    model, symbols = raw(given.bits), pieces(given.value, given.bits)
    if len(symbols) != -(-given.bits // 16):
        return Fails(f"pieces of 16 of {given.bits} bits", repr(symbols), WHOLE)
    return every(
        same(given.value, joined(symbols)),
        same(Accepted(Fraction(1, 2**given.bits)), probability(model, symbols)),
        _ends(model, symbols),
    )


LAWS_OF_COMBINED: Final[tuple[AnyLaw, ...]] = (
    Law(
        "automaton-is-contexts",
        Clause.INFO_COMBINE_1,
        "an automaton has the tables of contexts over static models",
        ANY_AUTOMATON,
        _automaton_is_contexts,
    ),
    Law(
        "contexts-learn-apart",
        Clause.INFO_COMBINE_1,
        "what is told in one context costs as if it were told to its model alone",
        SEVERAL,
        _contexts_learn_apart,
    ),
    Law(
        "turns-deal-out",
        Clause.INFO_COMBINE_2,
        "messages dealt out in turn cost together what they cost alone",
        SEVERAL,
        _turns_deal_out,
    ),
    Law(
        "until-stops",
        Clause.INFO_COMBINE_3,
        "it ends with the first stop symbol and costs the same",
        SEVERAL,
        _until_stops,
    ),
    Law(
        "times-counts",
        Clause.INFO_COMBINE_4,
        "it ends after so many symbols and costs the same",
        SEVERAL,
        _times_counts,
    ),
    Law(
        "followed-goes-on",
        Clause.INFO_COMBINE_5,
        "messages one after another cost together what they cost alone, and end with the last",
        SEVERAL,
        _followed_goes_on,
    ),
    Law(
        "refined-goes-into-detail",
        Clause.INFO_COMBINE_6,
        "coarse and fine symbols cost what they cost alone, the fine ones anew each time",
        SEVERAL,
        _refined_goes_into_detail,
    ),
    Law(
        "raw-bits-cost-themselves",
        Clause.INFO_COMBINE_7,
        "b raw bits have probability 2^-b, in pieces of 16, and come back",
        NUMBER,
        _raw_bits_cost_themselves,
    ),
)
