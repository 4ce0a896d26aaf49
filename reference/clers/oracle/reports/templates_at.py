"""Templates that come with the package, rendered strictly. Clauses: ORCL-HTML-3, ORCL-HTML-5."""

from collections.abc import Mapping
from functools import cache

from jinja2 import Environment, PackageLoader, StrictUndefined

from clers.oracle.reports.prose import prose


@cache
def _environment() -> Environment:
    """Whatever is put in is escaped; a name that is not known is an error."""
    environment = Environment(
        loader=PackageLoader("clers.oracle.reports"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["prose"] = prose
    return environment


def rendered(name: str, values: Mapping[str, object]) -> str:
    """A template with values in it; only what is marked `safe` there is markup. ORCL-HTML-5."""
    return _environment().get_template(name).render(values)
