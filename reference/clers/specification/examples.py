"""The rule on examples: what a page shows of the interpreter happens. Clause: CONV-PROSE-2."""

import doctest
from collections.abc import Iterator

from clers.specification.finding import Finding
from clers.specification.markdown import Fence, Page, fences
from clers.specification.repository import Repository


def transcripts(page: Page) -> tuple[Fence, ...]:
    """The `python` fences that show the interpreter at work."""
    return tuple(
        fence for fence in fences(page) if fence.language == "python" and ">>>" in fence.content
    )


def _run(page: Page) -> Iterator[Finding]:
    """One page's transcripts, in order, in one namespace."""
    parser, runner = doctest.DocTestParser(), doctest.DocTestRunner(verbose=False)
    names: dict[str, object] = {"__name__": page.path}
    for fence in transcripts(page):
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
                text = f"{example.source.strip()} {_told(''.join(said))}"
                yield Finding("example", page.path, fence.line + example.lineno, "", text)


def _told(report: str) -> str:
    """What doctest reports of an example, in a few words: expected and got, or what it raised."""
    words = report.strip()
    if "\nException raised:" in words:
        return "raised " + words.splitlines()[-1].strip()
    of_output = " ".join(words[words.rfind("\nExpected") :].split())
    return of_output.replace("Expected", "expected", 1).replace("Got", "got", 1)


def as_shown(of: Repository) -> Iterator[Finding]:
    """Every example of the pages gives what the page shows."""
    for page in of.pages:
        yield from _run(page)
