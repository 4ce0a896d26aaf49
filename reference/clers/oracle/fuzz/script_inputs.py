"""Scripts of operators of every family, as text, good or with one character changed."""

from typing import Final

from hypothesis import strategies as st

from clers.generate.attachments import attachment_scripts
from clers.generate.scripts import any_scripts
from clers.generate.sheets import sheet_scripts
from clers.operators import script_text
from clers.operators.attachments import text as attachments_text
from clers.operators.sheets import text as sheets_text
from clers.oracle.fuzz.changes import text_changed
from clers.oracle.fuzz.weighted import weighted

NUMBERS: Final = st.integers(0, 9999)


def scripts() -> st.SearchStrategy[str]:
    """Scripts as text. Clause: ORCL-FUZZ-1."""
    good = weighted(
        any_scripts(12).map(script_text.write),
        sheet_scripts(8).map(sheets_text.write),
        attachment_scripts(4, 6).map(attachments_text.write),
    )
    return weighted(good, good, st.builds(text_changed, good, NUMBERS, NUMBERS))
