"""All laws of chapter 5; those about codecs once for each of our four decoders."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.edgebreaker import laws_counts, laws_fold, laws_lists, laws_tree
from clers.edgebreaker.codec import FAST_ZIP, FOLD, REFERENCE, WRAP_AND_ZIP
from clers.edgebreaker.laws_codec import laws_of

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_of(REFERENCE),
    *laws_of(WRAP_AND_ZIP),
    *laws_of(FAST_ZIP),
    *laws_of(FOLD),
    *laws_counts.LAWS,
    *laws_fold.LAWS,
    *laws_lists.LAWS,
    *laws_tree.LAWS,
)
