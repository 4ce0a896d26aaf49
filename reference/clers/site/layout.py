"""The frame of every page, from templates that come with the package. Clause: TOOL-SITE-10."""

from collections.abc import Mapping
from functools import cache

from jinja2 import Environment, PackageLoader, StrictUndefined

from clers.site.places import href, up


@cache
def _environment() -> Environment:
    """Whatever is put in is escaped; a name that is not known is an error."""
    made = Environment(
        loader=PackageLoader("clers.site"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    made.globals["href"] = href
    return made


def laid_out(template: str, here: str, title: str, values: Mapping[str, object]) -> bytes:
    """A page of the site: `values` are what its template asks for."""
    known = {"top": up(here), "here": here, "title": title, **values}
    return _environment().get_template(template).render(known).encode()


def part_of(template: str, values: Mapping[str, object]) -> str:
    """A piece of a page, from a template of its own."""
    return _environment().get_template(template).render(values)
