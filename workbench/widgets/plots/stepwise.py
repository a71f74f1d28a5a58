"""A package that is imported statement by statement, for one that takes too long to be imported at once."""

import ast
import sys
from collections.abc import Iterator
from importlib.util import find_spec, module_from_spec


def import_stepwise(name: str) -> Iterator[None]:
    """Import a package of Python source, one statement of it in each step; none where it is imported already.

    Until the last step whoever imports it gets only a part of it. Where a step fails, or no more are taken,
    it is as if it had never been imported. Raises: ImportError where there is no such package.
    """
    if name in sys.modules:
        return
    spec = find_spec(name)
    if spec is None or spec.origin is None:
        raise ImportError(f"no package {name}", name=name)
    package = module_from_spec(spec)
    with open(spec.origin, encoding="utf-8") as source:
        statements = ast.parse(source.read(), spec.origin).body
    sys.modules[name] = package
    try:
        for statement in statements:
            part = ast.Module([statement], [])
            exec(compile(part, spec.origin, "exec", dont_inherit=True), package.__dict__)
            yield
    except BaseException:
        del sys.modules[name]
        raise
