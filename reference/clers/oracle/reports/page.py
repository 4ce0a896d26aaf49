"""An explanation as one HTML file. Clauses: ORCL-EXPLAIN-5, ORCL-HTML-3."""

from msgspec import UnsetType

from clers.oracle.explaining.explain import undoing
from clers.oracle.explaining.explanation import Explanation
from clers.oracle.reports.inline import inline
from clers.oracle.reports.templates_at import rendered
from clers.pictures.scene import Scene


def page(found: Explanation, image: Scene | None) -> str:
    """The explanation as one HTML document, with the picture if there is one.

    Clause: ORCL-EXPLAIN-5.
    """
    heard = None if isinstance(found.heard, UnsetType) else found.heard
    parted = None if heard is None else heard.judged.divergence
    fault = None if isinstance(found.fault, UnsetType) else found.fault
    text = f"The surface of {found.id}"
    return rendered(
        "explanation.html.jinja",
        {
            "found": found,
            "heard": heard,
            "parted": None if isinstance(parted, UnsetType) else parted,
            "fault": fault,
            "undoing": () if fault is None else undoing(fault),
            "svg": "" if image is None else inline(image, "f-", text),
            "text": text,
        },
    )
