"""Edits of a case's input: changes at places of a JSON value, and how they are undone.

Values are what JSON has: dictionaries, lists, strings, numbers, `True`, `False` and `None`.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import assert_never

import msgspec
from msgspec import Raw, UnsetType

from clers.conformance.cases.case import Case, Edit
from clers.conformance.cases.seals import resealed


@dataclass(frozen=True, slots=True)
class NoEdit:
    """What an edit says is there, and is not. Clause: ORCL-FAULT-6."""

    why: str


def replaced(path: str, at: int, old: object, new: object) -> Edit:
    """The edit that puts `new` for `old` at this place. Clause: ORCL-FAULT-2."""
    return Edit(path=path, at=at, remove=_raw(old), insert=_raw(new))


def inverse(edits: Sequence[Edit]) -> tuple[Edit, ...]:
    """The edits that undo these. Clauses: ORCL-FAULT-2, ORCL-FAULT-6."""
    return tuple(
        Edit(path=edit.path, at=edit.at, remove=edit.insert, insert=edit.remove)
        for edit in reversed(edits)
    )


def edited(given: Raw, edits: Sequence[Edit], *, sealed: bool = False) -> Raw | NoEdit:
    """The input after the edits, one after another; `sealed`, with its checksums made anew.

    Clause: ORCL-FAULT-2.
    """
    try:
        value = _value(given)
        for edit in edits:
            value = _at(value, edit)
            if isinstance(value, NoEdit):
                return value
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as fault:
        return NoEdit(str(fault))
    if sealed:
        value = _sealed(value)
    return value if isinstance(value, NoEdit) else _raw(value)


def undone(case: Case) -> Raw | NoEdit:
    """The input without the fault, which is the parent's. Clause: ORCL-FAULT-2."""
    if isinstance(case.fault, UnsetType):
        return NoEdit("the case has no fault")
    return edited(case.input, case.fault.undo, sealed=case.fault.sealed)


def same_input(one: Raw, other: Raw) -> bool:
    """Are these the same JSON value? The order of keys does not matter. Clause: ORCL-FAULT-2."""
    return _sorted(one) == _sorted(other)


def _sorted(given: Raw) -> bytes:
    """One text for each value, so that 1, 1.0 and true stay three."""
    return msgspec.json.encode(_value(given), order="sorted")


def _value(given: Raw) -> object:
    return msgspec.json.decode(given)


def _raw(value: object) -> Raw:
    return Raw(msgspec.json.encode(value))


def _at(value: object, edit: Edit) -> object:
    """The value with the edit done at the place to which its path leads, a JSON pointer."""
    keys = [key.replace("~1", "/").replace("~0", "~") for key in edit.path.split("/")[1:]]
    passed: list[dict[str, object] | list[object]] = []
    for key in keys:
        match value:
            case dict() if key in value:
                passed.append(value)
                value = value[key]
            case list() if key.isdecimal() and int(key) < len(value):
                passed.append(value)
                value = value[int(key)]
            case _:
                return NoEdit(f"{edit.path} leads nowhere")
    value = _done(value, edit)
    if isinstance(value, NoEdit):
        return value
    for key, whole in zip(reversed(keys), reversed(passed), strict=True):
        match whole:
            case dict():
                value = {**whole, key: value}
            case list():
                value = [*whole[: int(key)], value, *whole[int(key) + 1 :]]
            case _:
                assert_never(whole)
    return value


def _done(value: object, edit: Edit) -> object:
    """A part of a string or an array exchanged, or else the whole value."""
    old, new, at = _value(edit.remove), _value(edit.insert), edit.at
    match value, old, new:
        case str(), str(), str():
            if 0 <= at <= len(value) and value[at:].startswith(old):
                return value[:at] + new + value[at + len(old) :]
        case list(), list(), list():
            if 0 <= at <= len(value) and _raw(value[at : at + len(old)]) == _raw(old):
                return [*value[:at], *new, *value[at + len(old) :]]
        case _:
            if at == 0 and _raw(value) == _raw(old):
                return new
    return NoEdit(f"{bytes(edit.remove).decode()} is not at {edit.path}, place {at}")


def _sealed(value: object) -> object:
    match value:
        case {"hex": str(digits), **rest} if not rest:
            return {"hex": resealed(bytes.fromhex(digits)).hex()}
        case _:
            return NoEdit("only a file has seals")
