"""The rule on examples: an interpreter session in a page is what happens. Clause: CONV-PROSE-2."""

import doctest
from collections.abc import Iterator

from clers.specification.finding import Finding
from clers.specification.markdown import Fence, Page, fences
from clers.specification.repository import Repository


def sessions(page: Page) -> tuple[Fence, ...]:
    """The `python` fences that show an interpreter session."""
    return tuple(
        fence for fence in fences(page) if fence.language == "python" and ">>>" in fence.content
    )


def _run(page: Page) -> Iterator[Finding]:
    """One page's sessions, in order, in one namespace."""
    parser, runner = doctest.DocTestParser(), doctest.DocTestRunner(verbose=False)
    names: dict[str, object] = {"__name__": page.path}
    for fence in sessions(page):
        try:
            examples = parser.get_examples(fence.content)
        except ValueError as error:
            yield Finding("example", page.path, fence.line, "", str(error))
            continue
        for example in examples:
            said: list[str] = []
            one = doctest.DocTest([example], names, page.path, None, 0, None)
            runner.run(one, out=said.append, clear_globs=False)
            names = one.globs
            if said:
                got = "".join(said).partition("Expected")[2] or "".join(said)
                text = f"{example.source.strip()} expected {' '.join(got.split())}"
                yield Finding("example", page.path, fence.line + example.lineno, "", text)


def as_shown(of: Repository) -> Iterator[Finding]:
    """Every example of the pages gives what the page shows."""
    for page in of.pages:
        yield from _run(page)
