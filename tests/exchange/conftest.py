"""What tests of readers share: a place that bounds the time and memory they take."""

from collections.abc import Callable, Iterator

import pytest

from tests.soak.confined import Confined


@pytest.fixture(scope="module")
def confined() -> Iterator[Callable[[str, str], str]]:
    """What ``Confined`` says of a call over these imports; calls of the same imports share one."""
    parents: dict[str, Confined] = {}

    def said(imports: str, call: str) -> str:
        if imports not in parents:
            parents[imports] = Confined(imports)
        return parents[imports](call)

    yield said
    for parent in parents.values():
        parent.close()
