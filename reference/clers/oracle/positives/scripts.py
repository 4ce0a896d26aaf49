"""Scripts of operators of all three families, with operators that do nothing among them."""

from collections.abc import Iterator, Sequence
from random import Random
from typing import Final

from clers.complexes.simplicial import Complex, closure
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.cases.case import Origin
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.on_sheets import on_sheets
from clers.generate.kinds import EVERY, random_script
from clers.operators import script_text as total_text
from clers.operators.attachments import examples
from clers.operators.attachments import text as attachments_text
from clers.operators.attachments.operator import Script, Undo
from clers.operators.families import read, stages
from clers.operators.moves import apply as moving
from clers.operators.moves import text as moves_text
from clers.operators.moves.candidates import chosen
from clers.operators.sheets import text as sheets_text
from clers.operators.sheets.apply import apply as apply_to_sheet
from clers.operators.sheets.build import build
from clers.operators.sheets.euler import euler
from clers.operators.sheets.operator import Operator, taken_apart
from clers.operators.sheets.proposals import in_reach
from clers.operators.sheets.sheet import EMPTY
from clers.oracle.positives.asked import Asked
from clers.oracle.positives.stock import by_hand

GROWING: Final = (Clause.OPER_FAMILY_1, Clause.OPER_FAMILY_3, Clause.OPER_SCRIPT_1)


def asked(
    slug: str, text: str, clauses: Sequence[Clause], origin: Origin = "hand", *flags: str
) -> Asked:
    """A script with its stages; its size is the most faces of a stage."""
    script = read(text)
    if not isinstance(script, Accepted):
        raise AssertionError(f"{slug}: {script.line()}")
    done, _ = stages(script.value)
    counted = (dict(stage.numbers) for stage in done)
    size = max((counts.get("faces", counts.get("#2", 0)) for counts in counted), default=0)
    idle = ["idle-operator"] if any(stage.idle for stage in done) else []
    return Asked(
        slug, "operator.apply", message.Apply(id=0, input=form.ScriptForm(script=text)),
        tuple(clauses), origin, (), size, (*flags, *idle),
    )  # fmt: skip


_OF_GROWTH: Final = {
    "split-face": Clause.OPER_REFINE_1,
    "split-edge": Clause.OPER_REFINE_2,
    "flip-edge": Clause.OPER_REFINE_3,
    "relabel": Clause.OPER_REFINE_4,
    "add-ear": Clause.OPER_BORDER_1,
    "fill-corner": Clause.OPER_BORDER_2,
    "close-curve": Clause.OPER_BORDER_3,
    "open-curve": Clause.OPER_BORDER_4,
    "remove-face": Clause.OPER_BORDER_5,
    "remove-star": Clause.OPER_BORDER_6,
    "cut-edge": Clause.OPER_BORDER_7,
    "add-tetrahedron": Clause.OPER_TUBE_2,
    "add-handle": Clause.OPER_TUBE_3,
    "join-components": Clause.OPER_TUBE_4,
    "bridge": Clause.OPER_TUBE_5,
}
"""The clause of each operator that grows surfaces."""

_BY_HAND: Final = (
    ("nothing", "relabel 0"),
    ("split-and-flip", "split-face 0; split-face 1; flip-edge 5; flip-edge 3; split-edge 2"),
    ("numbers-come-round", "split-face 1000000007; split-face -1; flip-edge -5; split-edge -77"),
    ("very-long-numbers", f"split-face {10**40 + 3}; split-edge -{10**25}"),
    ("open-and-close", "open-curve 0; add-ear 0; add-ear 1; fill-corner 0; close-curve 0"),
    ("two-curves-and-a-bridge", "open-curve 0; open-curve 3; bridge 0 5; fill-corner 2"),
    ("handle-then-cut", "add-handle 0 3; open-curve 1; cut-edge 4; cut-edge 9; cut-edge 14"),
    ("components-joined", "add-tetrahedron; add-tetrahedron; join-components 0 1; add-handle 2 9"),
    ("taken-away", "split-face 0; split-face 0; remove-face 0; remove-face 1; remove-face 0"),
    ("star-taken-away", "split-face 0; split-face 4; split-edge 3; remove-star 4; remove-star 0"),
    ("to-the-last-face", "; ".join(f"remove-face {k}" for k in (0, 0, 0, 0))),
    ("relabelled", "split-face 0; relabel 5; split-face 0; relabel 77; flip-edge 2"),
    ("idle-on-a-sphere", "add-ear 0; fill-corner 0; close-curve 0; bridge 0 1; cut-edge 0"),
    ("flip-is-idle", "flip-edge 0; flip-edge 1; flip-edge 2"),
    ("lines-and-semicolons", "split-face 0\nsplit-face 1;\n\nflip-edge 2;;flip-edge 3"),
)


def growth(slug: str, text: str, origin: Origin) -> Asked:
    """A script of total operators, with the clauses of those that are in it."""
    names = {piece.split()[0] for piece in text.replace("\n", ";").split(";") if piece.strip()}
    of_names = (clause for name, clause in _OF_GROWTH.items() if name in names)
    return asked(slug, text, (*GROWING, Clause.OPER_SCRIPT_2, *of_names), origin)


def growths() -> Iterator[Asked]:
    """Total operators: by hand, every one with every other, and at random."""
    for slug, text in _BY_HAND:
        yield growth(slug, text, "hand")
    draw = Random(9).random
    for number, kind in enumerate(EVERY):
        others = (kind(int(draw() * 99), int(draw() * 99)) for _ in range(3))
        mixed = (other for one in others for other in (one, EVERY[int(draw() * len(EVERY))](7, 4)))
        yield growth(f"each-in-turn-{number}", total_text.write(tuple(mixed)), "generated")
    for seed in range(60):
        yield growth(
            f"random-{seed}", total_text.write(random_script(seed, 4 + seed % 20)), "generated"
        )


_ON_SHEETS: Final = (
    Clause.OPER_FAMILY_1,
    Clause.OPER_FAMILY_3,
    Clause.OPER_SHEET_3,
    Clause.OPER_SHEET_5,
)


def sheets() -> Iterator[Asked]:
    """Handle and Euler operators that build a surface and take it apart, and others at random."""
    for named in by_hand():
        if named.surface.faces > 40:
            continue
        handles = build(named.surface)
        small = euler(handles)
        walk = on_sheets(encode(named.surface).stream)
        if not isinstance(small, Accepted) or not isinstance(walk, Accepted):
            raise AssertionError(f"{named.slug}: no script")
        for word, script, clauses in (
            ("by-handles", handles, (Clause.OPER_BUILD_1, Clause.OPER_BUILD_2)),
            ("by-euler", small.value, (Clause.OPER_BUILD_4, Clause.OPER_EFFECT_2)),
            ("by-walk", walk.value, (Clause.OPER_SHEET_7, Clause.EB_FOLD_4)),
            (
                "and-apart",
                (*handles, *taken_apart(handles)),
                (Clause.OPER_BUILD_1, Clause.OPER_SHEET_6),
            ),
        ):
            text = sheets_text.write(script)
            yield asked(f"{named.slug}-{word}", text, (*_ON_SHEETS, *clauses), named.origin)
    for seed in range(20):
        yield _on_a_sheet(seed, 6 + seed % 9)


def _on_a_sheet(seed: int, length: int) -> Asked:
    """Operators that apply, one after another, drawn among those in reach."""
    draw = Random(seed).random
    sheet, script = EMPTY, list[Operator]()
    while len(script) < length:
        reach = list(in_reach(sheet))
        start = int(draw() * len(reach))
        for operator in reach[start:] + reach[:start]:
            after = apply_to_sheet(operator, sheet)
            if isinstance(after, Accepted):
                sheet = after.value
                script.append(operator)
                break
        else:
            break
    text = "; ".join(sheets_text.write((operator,)) for operator in script)
    return asked(f"random-sheet-{seed}", text, (*_ON_SHEETS, Clause.OPER_EFFECT_2))


_ON_COMPLEXES: Final = (Clause.OPER_FAMILY_1, Clause.OPER_FAMILY_3)

_COMPLEXES: Final = (
    ("arc-and-circle", "first-vertex 3; edge-and-vertex 3 1; edge-and-vertex 1 8; "
     "edge-between-ends 3 8", Clause.OPER_CURVE_2),
    ("branch", "first-vertex 0; edge-and-vertex 0 1; edge-and-vertex 1 2; "
     "edge-and-vertex 2 3; edge-at-interior 1 3", Clause.OPER_CURVE_5),
    ("collapse-to-a-point", "attach 0 1 2\nsubdivide 0 1 2 / 7; collapse 0 1 / 0 1 7; "
     "collapse 0 7 / 0 2 7; collapse 0 / 0 2; collapse 1 7 / 1 2 7; "
     "collapse 1 / 1 2; collapse 7 / 2 7", Clause.OPER_COLLAPSE_1),
    ("expand-and-collapse", "attach 4; expand 5 / 4 5; expand 6 / 5 6; expand 4 6 / 4 5 6; "
     "collapse 4 5 / 4 5 6", Clause.OPER_COLLAPSE_3),
    ("apart-and-together", "attach 0 1; attach 2 3; attach 4; attach 1 2 / 1 / 2",
     Clause.OPER_ATTACH_2),
    ("attached-and-undone", "attach 0 1 2; attach 2 3 / 2; undo attach 2 3 / 2; "
     "undo attach 0 1 2", Clause.OPER_ATTACH_3),
    ("weld-undoes-subdivide", "attach 0 1 2 3; subdivide 0 1 / 9; weld 0 1 / 9",
     Clause.OPER_STELLAR_2),
)  # fmt: skip


def complexes() -> Iterator[Asked]:
    """Moves and attachments: by hand, spheres and solids built, and moves at random."""
    for slug, text, clause in _COMPLEXES:
        yield asked(slug, text, (*_ON_COMPLEXES, clause))
    for slug, script in (
        ("circle", examples.sphere(1)),
        ("sphere-of-4", examples.sphere(2)),
        ("three-sphere", examples.THREE_SPHERE),
        ("ball", examples.BALL),
        ("solid-torus", examples.SOLID_TORUS),
    ):
        clauses = (*_ON_COMPLEXES, Clause.OPER_ATTACH_2, Clause.OPER_SOLID_6)
        yield asked(slug, attachments_text.write(script), clauses)
    ball = (*examples.BALL, *taken_off(examples.BALL))
    yield asked(
        "ball-and-apart", attachments_text.write(ball), (*_ON_COMPLEXES, Clause.OPER_ATTACH_3)
    )
    starts = {
        "circle": closure([(0, 1), (1, 2), (0, 2)]),
        "sphere": closure([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)]),
        "disk": closure([(0, 1, 2), (1, 2, 3)]),
        "ball": closure([(0, 1, 2, 3)]),
    }
    for seed in range(24):
        name = tuple(starts)[seed % len(starts)]
        yield _moved(f"random-moves-{seed}-on-a-{name}", starts[name], seed)


def taken_off(script: Script) -> Iterator[Undo]:
    """The operators that undo a script. Clause: OPER-ATTACH-3."""
    return (Undo(step) for step in reversed(script) if not isinstance(step, Undo))


def _moved(slug: str, start: Complex, seed: int) -> Asked:
    """A complex is attached simplex by simplex; then come moves at random."""
    draw = Random(seed).random
    built = attachments_text.write(examples.build(start)).replace("\n", "; ")
    texts = [built]
    k = start
    for _ in range(6):
        move = chosen(k, int(draw() * 10**6))
        after = moving.apply(move, k) if move is not None else None
        if move is not None and isinstance(after, Accepted):
            k = after.value
            texts.append(moves_text.write((move,)))
    clauses = (*_ON_COMPLEXES, Clause.OPER_ATTACH_7, Clause.OPER_MOVE_4)
    return asked(slug, "; ".join(texts), clauses, "generated")


def scripts() -> Iterator[Asked]:
    """All three families."""
    yield from growths()
    yield from sheets()
    yield from complexes()
