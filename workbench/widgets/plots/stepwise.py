"""A package that is imported statement by statement, for one that takes too long to be imported at once."""

import ast
import sys
from collections.abc import Iterator
from importlib.util import find_spec, module_from_spec


def import_stepwise(name: str) -> Iterator[None]:
    """Import a package of Python source, one statement of it in each step; nothing where it is there.

    Before the last step who imports it gets a part of it. ImportError: it is missing, or was given up.
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
            exec(compile(ast.Module([statement], []), spec.origin, "exec"), package.__dict__)
            yield
    except BaseException:
        del sys.modules[name]
        raise
