"""The laws of chapter 1."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.information.laws_codes import LAWS_OF_CODES
from clers.information.laws_combined import LAWS_OF_COMBINED
from clers.information.laws_counting import LAWS_OF_COUNTING
from clers.information.laws_huffman import LAWS_OF_HUFFMAN
from clers.information.laws_learning import LAWS_OF_LEARNING
from clers.information.laws_measure import LAWS_OF_MEASURE
from clers.information.laws_models import LAWS_OF_MODELS

LAWS: Final[tuple[AnyLaw, ...]] = (
    *LAWS_OF_MEASURE,
    *LAWS_OF_MODELS,
    *LAWS_OF_COMBINED,
    *LAWS_OF_CODES,
    *LAWS_OF_HUFFMAN,
    *LAWS_OF_COUNTING,
    *LAWS_OF_LEARNING,
)
