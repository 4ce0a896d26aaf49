"""Letters that count: a, b, …, z, aa, ab, …"""

from string import ascii_lowercase


def letters(number: int) -> str:
    """The name of thing number `number` ≥ 0, as columns of a table are named."""
    name = ""
    rest = number + 1
    while rest > 0:
        rest, digit = divmod(rest - 1, len(ascii_lowercase))
        name = ascii_lowercase[digit] + name
    return name
