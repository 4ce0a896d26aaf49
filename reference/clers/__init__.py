"""clers: a reference implementation of Edgebreaker, written from its specification."""

from typing import Final

__version__: Final = "0.1.0"
SPEC_VERSION: Final = "0.1"
