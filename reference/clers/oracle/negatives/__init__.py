"""Cases with one fault each, their good parents, the limits, and what no encoder of ours wrote."""

from clers.oracle.negatives.all import negatives
from clers.oracle.negatives.canaries import canaries
from clers.oracle.negatives.flags import FLAGS

__all__ = ["FLAGS", "canaries", "negatives"]
