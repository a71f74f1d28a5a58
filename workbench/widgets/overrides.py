"""A fault in an override of a Qt method is told like any other, and ends nothing.

Before Python 3.12 what C code raises, such as an index outside an array, may leave a function as a bare
text. PySide takes that for an exception when it leaves an override, and the process ends. Caught and raised
again it is an exception. Imported before any class that overrides, by the packages that have some.
"""

import sys
from collections.abc import Callable
from functools import wraps
from types import FunctionType
from typing import Any

from PySide6.QtCore import QObject

MARK = "_raises_exceptions"


def raising(method: FunctionType) -> Callable[..., Any]:
    """``method``, out of which nothing comes but exceptions; as PySide, it leaves out arguments that it does
    not take."""
    code = method.__code__
    most = None if code.co_flags & 4 else code.co_argcount  # 4: it takes any number

    @wraps(method)
    def override(*arguments: Any, **named: Any) -> Any:
        try:
            return method(*arguments[:most], **named)
        except BaseException:
            raise

    setattr(override, MARK, True)
    return override


def overrides_of(kind: type) -> dict[str, FunctionType]:
    """The methods of Qt that a class overrides, itself or by a base that knows nothing of Qt."""
    bases = kind.__mro__
    bound = [vars(base) for base in bases if base.__module__.startswith("PySide6.")]
    overrides: dict[str, FunctionType] = {}
    for owner in bases:
        if owner is not kind and issubclass(owner, QObject):
            continue  # what is its own was seen to when it was made
        for name, member in vars(owner).items():
            if isinstance(member, FunctionType) and not name.startswith("__"):
                first = next(base for base in bases if name in vars(base))
                if first is owner and any(name in names for names in bound):
                    overrides[name] = member
    return overrides


def _guard(kind: type[QObject], /, **named: Any) -> None:
    super(QObject, kind).__init_subclass__(**named)
    for name, method in overrides_of(kind).items():
        if not hasattr(method, MARK):
            setattr(kind, name, raising(method))


if sys.version_info < (3, 12):
    QObject.__init_subclass__ = classmethod(_guard)  # type: ignore[assignment]
