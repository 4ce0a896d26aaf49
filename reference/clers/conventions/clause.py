"""Generated from spec/ by `clers spec generate`; do not edit."""

from enum import StrEnum


class Clause(StrEnum):
    """Every clause of the specification, by id."""

    CONV_RESULT_1 = "CONV-RESULT-1"
    CONV_RESULT_2 = "CONV-RESULT-2"
    CONV_RESULT_3 = "CONV-RESULT-3"
    CONV_RESULT_4 = "CONV-RESULT-4"
    CONV_RESULT_5 = "CONV-RESULT-5"
    CONV_LAW_1 = "CONV-LAW-1"
    CONV_LAW_2 = "CONV-LAW-2"
    CONV_LAW_3 = "CONV-LAW-3"
    CONV_LAW_4 = "CONV-LAW-4"
