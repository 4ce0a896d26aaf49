"""Smaller words, bits, files, messages and scripts. Clause: ORCL-SHRINK-3."""

from collections.abc import Iterator
from itertools import chain

import msgspec

from clers.conformance import payloads as form
from clers.conformance.numbers import from_wire, to_wire
from clers.container.section import sections
from clers.conventions.result import Accepted
from clers.edgebreaker.stream import SYMBOLS
from clers.generate.tamper import PROLOGUE, joined
from clers.oracle.fuzz.changes import bits_of_digits, digits_of
from clers.oracle.fuzz.shrinking.blocks import nearer, without_blocks

Closers = frozenset("RLE")


def smaller_streams(given: form.StreamForm) -> Iterator[form.StreamForm]:
    """Without a part of the word, or a record, or with a smaller number. Clause: ORCL-SHRINK-3."""
    places = range(len(given.word))
    branches = (tuple(i for i in places if not a <= i < b) for a, b in _branches(given.word))
    for kept in chain(branches, without_blocks(places)):
        yield _restricted(given, kept)
    for records in without_blocks(given.handles):
        yield msgspec.structs.replace(given, handles=records)
    for r, record in enumerate(given.handles):
        changes = (
            *(msgspec.structs.replace(record, s=to_wire(n)) for n in nearer(from_wire(record.s))),
            *(msgspec.structs.replace(record, at=to_wire(n)) for n in nearer(from_wire(record.at))),
        )
        for new in changes:
            records = (*given.handles[:r], new, *given.handles[r + 1 :])
            yield msgspec.structs.replace(given, handles=records)
    for count in nearer(from_wire(given.components_with_boundary)):
        yield msgspec.structs.replace(given, components_with_boundary=to_wire(count))


def _branches(word: str) -> Iterator[tuple[int, int]]:
    """From each symbol to the E that ends its branch, as S and E match; long ones first."""
    found: list[tuple[int, int]] = []
    for start in range(len(word)):
        depth = 1
        for i in range(start, len(word)):
            depth += (word[i] == "S") - (word[i] == "E")
            if depth == 0:
                found.append((start, i + 1))
                break
    yield from sorted(found, key=lambda pair: pair[0] - pair[1])


def _restricted(given: form.StreamForm, kept: tuple[int, ...]) -> form.StreamForm:
    """The symbols kept, and the records whose S and closing symbol are among them, renumbered."""
    word = given.word
    chosen = set(kept)
    splits = [i for i, x in enumerate(word) if x == "S"]
    closers = [i for i, x in enumerate(word) if x in Closers]
    new_split = {i: k for k, i in enumerate(i for i in splits if i in chosen)}
    new_closer = {i: k for k, i in enumerate(i for i in closers if i in chosen)}
    records: list[form.HandleForm] = []
    for record in given.handles:
        s, at = from_wire(record.s), from_wire(record.at)
        if not (0 <= s < len(splits) and 0 <= at < len(closers)):
            records.append(record)
        elif splits[s] in chosen and closers[at] in chosen:
            numbers = new_split[splits[s]], new_closer[closers[at]]
            records.append(msgspec.structs.replace(record, s=numbers[0], at=numbers[1]))
    letters = "".join(word[i] for i in kept)
    return msgspec.structs.replace(given, word=letters, handles=tuple(records))


def plainer_words(given: form.StreamForm) -> Iterator[form.StreamForm]:
    """One symbol earlier in the alphabet. Clause: ORCL-SHRINK-3."""
    for i, x in enumerate(given.word):
        for other in SYMBOLS[: max(SYMBOLS.find(x), 0)]:
            yield msgspec.structs.replace(given, word=given.word[:i] + other + given.word[i + 1 :])


def smaller_bits(given: form.BitString) -> Iterator[form.BitString]:
    """Without a block of bits, or one. Clause: ORCL-SHRINK-3."""
    for kept in without_blocks(digits_of(given)):
        yield bits_of_digits("".join(kept))


def smaller_files(data: bytes) -> Iterator[bytes]:
    """Without a section; with a payload's block removed, sealed again; without any block."""
    found = sections(data, PROLOGUE) if len(data) >= PROLOGUE else None
    if isinstance(found, Accepted):
        parts = [(s.tag.encode("ascii"), data[s.start : s.stop]) for s in found.value]
        for some in without_blocks(parts):
            yield joined(data[:PROLOGUE], some)
        for p, (tag, payload) in enumerate(parts):
            for kept in without_blocks(payload):
                changed = [*parts[:p], (tag, bytes(kept)), *parts[p + 1 :]]
                yield joined(data[:PROLOGUE], changed)
    for kept in without_blocks(data):
        yield bytes(kept)


def smaller_messages(given: form.ToCode) -> Iterator[form.ToCode]:
    """Without symbols, or with a smaller number. Clause: ORCL-SHRINK-3."""
    for symbols in without_blocks(given.symbols):
        yield msgspec.structs.replace(given, symbols=symbols)
    for i, symbol in enumerate(given.symbols):
        for new in nearer(from_wire(symbol)):
            symbols = (*given.symbols[:i], to_wire(new), *given.symbols[i + 1 :])
            yield msgspec.structs.replace(given, symbols=symbols)
    for model in smaller_models(given.model):
        yield msgspec.structs.replace(given, model=model)


def smaller_models(model: form.ModelForm) -> Iterator[form.ModelForm]:
    """With a smaller number, or without the last frequency. Clause: ORCL-SHRINK-3."""
    match model:
        case form.UniformForm(size=size):
            for number in nearer(from_wire(size)):
                yield form.UniformForm(size=to_wire(number))
            return
        case form.AdaptiveForm():
            yield form.StaticForm(frequencies=model.frequencies)
            for number in nearer(from_wire(model.increment)):
                yield msgspec.structs.replace(model, increment=to_wire(number))
            for number in nearer(from_wire(model.limit)):
                yield msgspec.structs.replace(model, limit=to_wire(number))
        case form.StaticForm():
            pass
    table = model.frequencies
    yield msgspec.structs.replace(model, frequencies=table[:-1])
    for i, frequency in enumerate(table):
        for number in nearer(from_wire(frequency)):
            changed = (*table[:i], to_wire(number), *table[i + 1 :])
            yield msgspec.structs.replace(model, frequencies=changed)


def smaller_scripts(script: str) -> Iterator[str]:
    """Without operators, or with a smaller number; at last without a character. ORCL-SHRINK-3."""
    steps = script.split(";")
    for kept in without_blocks(steps):
        yield ";".join(kept).strip()
    for i, step in enumerate(steps):
        words = step.split(" ")
        for w, word in enumerate(words):
            if word.removeprefix("-").isdecimal() and len(word) < 1000:
                for number in nearer(int(word)):
                    changed = " ".join((*words[:w], str(number), *words[w + 1 :]))
                    yield ";".join((*steps[:i], changed, *steps[i + 1 :]))
    for characters in without_blocks(script):
        yield "".join(characters)
