"""The compiled reading: the lowered text at the speed of a hand-written loop. Only this module knows numba.

Every function here also serves without numba, then by running the same lowered text as Python. Kernels are
kept (see ``kernel_files``); they are compiled on first use, which takes a second or more: ``ready`` tells
beforehand, and with ``compiling=False`` the interpreted reading serves instead of a compilation.
"""

import functools
import importlib.util
import inspect
import itertools
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Emits
from workbench.engine import arguments, at_hand, kernel_files, overloads
from workbench.engine.dialect import NotCompilable
from workbench.engine.drivers import PAINTING, drivers, ticking_drivers
from workbench.engine.lowered_files import lowered as lowered_text
from workbench.engine.lowering import Lowered, Variant
from workbench.engine.processor import load_llvm, mask_short_loops
from workbench.engine.stopping import Stop, Stopped
from workbench.engine.texts import DECORATORS
from workbench.engine.turns import imports_in_turn, short_turns
from workbench.language import _

__all__ = [
    "NotCompilable",
    "Stop",
    "Stopped",
    "available",
    "collect",
    "collect_many",
    "hits",
    "paint",
    "paint_many",
    "ready",
    "ready_on",
]

Function = Callable[..., Any]


@functools.cache
def _numba() -> ModuleType | None:
    """numba with our ``emit`` made known to it; None when it cannot be imported."""
    try:
        with imports_in_turn, short_turns:
            load_llvm()
            import numba
            import numba.extending
    except ImportError:
        return None
    mask_short_loops()
    overloads.register(numba)
    return numba


def available() -> bool:
    """Whether there is a compiler; a look that costs nothing as long as nothing was compiled."""
    if importlib.util.find_spec("numba") is None:
        return False
    return not _numba.cache_info().currsize or _numba() is not None


@dataclass(slots=True)
class Kernel:
    """The drivers of one function: its text with them, and the module once it is loaded."""

    function: Function
    text: str
    lowered: Lowered
    emits: Emits | None
    writes: bool
    flavour: str
    refusal: str
    key: str
    modules: dict[bool, ModuleType] = field(default_factory=dict)
    used: dict[str, Function] = field(default_factory=dict)
    lock: threading.RLock = field(default_factory=threading.RLock)

    def call(self, driver: str, values: tuple[Any, ...], compiling: bool, stop: Stop | None = None) -> None:
        """Run a driver, compiled where that can be. Raises: Stopped, where ``stop`` was set by its end."""
        use = _use(driver, tuple([v.dtype for v in values if type(v) is np.ndarray]))
        known = self.used.get(use)
        if known is not None:
            known(*values)
        else:
            self._first(driver, use, values, compiling)
        if stop is not None:
            stop.check()

    def _first(self, driver: str, use: str, values: tuple[Any, ...], compiling: bool) -> None:
        compiling = (compiling or self.ready(use)) and self.flavour != "interpreted"
        numba = _numba() if compiling and not self.refusal and available() else None
        if numba is None:
            getattr(self._module(False), driver)(*values)
            return
        self._run(driver, values, self.ready(use), numba.core.errors.NumbaError)
        self.used[use] = getattr(self._module(True), driver)
        kernel_files.mark(self.key, use)
        if not self.flavour:
            at_hand.note(self.function, use.partition("-")[0])

    def _run(self, driver: str, values: tuple[Any, ...], ready: bool, refused: type[Exception]) -> None:
        """Run a compiled driver; what is kept of it costs time when it fails, and is gone on without."""
        for again in itertools.count():
            try:
                with kernel_files.alone(self.key, unless=ready and not again):
                    getattr(self._module(True), driver)(*values)
                return
            except refused as error:
                raise NotCompilable(f"{self.lowered.name}: {str(error).strip().splitlines()[0]}") from error
            except Exception as error:
                with self.lock:
                    if not kernel_files.given_up(self.key, error, again > 0):
                        raise
                    self.modules.pop(True, None)

    def ready(self, use: str) -> bool:
        """Whether this use was compiled before."""
        return use in self.used or kernel_files.marked(self.key, use)

    def known(self) -> set[str]:
        """All uses that were compiled before."""
        return self.used.keys() | kernel_files.marks(self.key)

    def _module(self, compiled: bool) -> ModuleType:
        with self.lock:
            if compiled not in self.modules:
                self.modules[compiled] = self._load() if compiled else self._executed({})
            return self.modules[compiled]

    def _load(self) -> ModuleType:
        numba: Any = _numba()
        # The compiler has folders of its own, which variables of the system name: only ours are looked at
        numba.config.CACHE_DIR, numba.config.CACHE_LOCATOR_CLASSES = "", "InTreeCacheLocator"
        file = kernel_files.write(self.text, self.key)
        options = {"cache": file is not None, "nogil": True, "boundscheck": self.flavour == "checked"}
        # Python calls the drivers only: what lets it call the rest takes a quarter of the time to compile
        inner = {**options, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
        marks = {"driver": numba.njit(**options), "reading": numba.njit(**inner)}
        marks["part"] = numba.njit(**inner, forceinline=True)
        return self._executed(marks) if file is None else kernel_files.load(file, marks)

    def _executed(self, marks: dict[str, Any]) -> ModuleType:
        """The text as a module that no file holds; its decorators are given by name, or do nothing."""
        module = ModuleType(f"kernel_{self.lowered.name}")
        vars(module).update(marks or dict.fromkeys(DECORATORS, lambda function: function))
        exec(compile(self.text, f"<{self.lowered.name}>", "exec"), vars(module))
        return module


@functools.lru_cache(maxsize=1024)
def _use(driver: str, dtypes: tuple[np.dtype[Any], ...]) -> str:
    """Name of one use of a kernel: the driver and the kinds of the arrays it is given."""
    return "-".join([driver.lstrip("_"), *(dtype.str[1:] for dtype in dtypes)])


def kernel(
    function: Function, emits: Emits | None = None, flavour: str = "", variant: Variant = "plain"
) -> Kernel:
    """The kernel of a function, one for the whole process, compiled when first called.

    The flavour ``checked`` tests all indexes, ``interpreted`` runs the lowered text as Python.
    ``emits`` is needed only for a function without an entry. Raises DialectError.
    """
    entry = arguments.entry_of(function)
    return _kernel(function, entry.emits if entry is not None else emits, flavour, variant)


@functools.cache
def _kernel(function: Function, emits: Emits | None, flavour: str, variant: Variant) -> Kernel:
    entry = arguments.entry_of(function)
    considers = arguments.considered(entry) if entry is not None and variant == "probing" else ()
    painter = entry.painter if entry is not None and variant == "plain" else None
    lowered = lowered_text(function, variant, considers, painter)
    kinds = arguments.kinds(function)
    refusal = entry.compiles if entry is not None else ""
    if entry is None and lowered.recursive:
        refusal = _("it calls itself, and nothing tells how deep")
    if emits is None:
        emits = _inferred(function, lowered.arity)
    if variant == "plain":
        extent = entry.extent if entry is not None else ""
        added = drivers(lowered.name, kinds, emits, extent, "" if painter is None else painter.__name__)
    else:
        added = ticking_drivers(lowered.name, kinds, emits, variant == "probing")
    text = lowered.text + "\n" + added
    writes = entry is not None and bool(entry.writes)
    key = kernel_files.key(text, flavour)
    return Kernel(function, text, lowered, emits, writes, flavour, refusal, key)


def _inferred(function: Function, arity: int) -> Emits | None:
    """What a function without an entry emits, by how many numbers and what it says of them."""
    said = str(inspect.signature(function).return_annotation)
    if arity == 2:
        return "points" if "float" in said else "pixels"
    if arity == 3:
        return "coverage" if "float" in said else "spans" if said.count("int") >= 3 else None
    return "fragments" if arity == 4 and "float" in said else None


def ready(function: Function, use: str = "paint", dtype: str = "uint32", flavour: str = "") -> bool:
    """Whether a use needs no compilation now: paint, paint_many, collect, count, probe or hits.

    ``dtype`` is that of the picture painted. Without a compiler, and for a text that is stepped only, nothing
    is ever ready.
    """
    variant: Variant = "counting" if use == "count" else "probing" if use == "probe" else "plain"
    one = kernel(function, None, flavour, variant)
    if one.refusal or not available():
        return False
    prefix = use
    if use == "paint" and one.writes:
        prefix = "run"
    elif use in ("paint", "paint_many"):
        prefix = f"{use}-{np.dtype(dtype).str[1:]}"
    return any(f"{known}-".startswith(f"{prefix}-") for known in one.known())


def ready_on(function: Function, *args: Any) -> bool:
    """Whether a text that paints itself needs no compilation now for such arguments."""
    one = kernel(function)
    values = arguments.bind(function, args, False)
    use = _use("_run", tuple([value.dtype for value in values if type(value) is np.ndarray]))
    return not one.refusal and available() and one.ready(use)


def collect(
    function: Function,
    *args: Any,
    stop: Stop | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> NDArray[Any]:
    """Everything emitted, an (n, k) array: int64 for pixels and spans, else float64. Arrays are copied.

    Raises:
        Stopped: ``stop`` was set. DialectError, NotCompilable: the text cannot be run so.
        TypeError, ValueError: the arguments do not fit.
    """
    one = kernel(function, flavour=flavour)
    room = arguments.expected(function, args)
    return _collected(one, "_collect", lambda: arguments.bind(function, args, True), room, stop, compiling)


def collect_many(
    function: Function,
    rows: Any,
    *,
    stop: Stop | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> tuple[NDArray[Any], NDArray[np.int64]]:
    """As ``collect``, once for each row of arguments in ``rows`` (n, number of parameters).

    Returns everything emitted, and for each row (n,) how much was emitted up to its end. Raises as
    ``collect``, and ValueError for a text that takes more than numbers.
    """
    one = kernel(function, flavour=flavour)
    table = arguments.table(function, rows)
    ends = np.zeros(len(table), np.int64)
    room = max(4096, len(table) * (48 if one.emits == "points" else 1))  # points of a row are a chain
    return _collected(one, "_collect_many", lambda: (ends, table), room, stop, compiling), ends


def _collected(
    one: Kernel, driver: str, rest: Callable[[], Any], room: int, stop: Stop | None, compiling: bool
) -> NDArray[Any]:
    """What a driver collects, (n, k), given the ``rest`` of its arguments; run again where it had no room."""
    arity = one.lowered.arity
    dtype: Any = np.int64 if one.emits in ("pixels", "spans") else np.float64
    stop = stop or Stop()
    while True:
        values, count = np.zeros(room * arity, dtype), np.zeros(1, np.int64)
        one.call(driver, (values, count, stop.flag, *rest()), compiling, stop)
        if count[0] <= room:
            found = values[: count[0] * arity].reshape(-1, arity)
            return found if 2 * count[0] > room else found.copy()
        room = int(count[0])


def paint(
    function: Function,
    image: NDArray[Any],
    value: Any,
    *args: Any,
    emits: Emits | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> None:
    """Paint what is emitted with ``value`` into ``image`` (h, w), clipped to it.

    A text that writes its own picture among ``args`` paints itself, and nothing is added to that.

    Raises:
        ValueError: what is emitted cannot be painted, or ``image`` is not an array of integers with two axes.
    """
    known = _painters.get(function)
    if known is not None and not flavour and known.paints(image, value, args):
        return
    one = kernel(function, emits, flavour)
    values = arguments.bind(function, args, False)
    if one.writes or (arguments.entry_of(function) is None and arguments.among(image, args)):
        one.call("_run", values, compiling)
        for given, formed in zip(args, values, strict=False):
            if isinstance(given, np.ndarray) and given is not formed and given.flags.writeable:
                given[...] = formed
        return
    _paintable(one)
    picture = _picture(image)
    one.call("_paint", (picture, picture.dtype.type(value), *values), compiling)
    if not flavour and arguments.entry_of(function) is not None:
        _remember_painter(one, picture, values)
    if picture is not image:
        image[...] = picture


# The last painter of each text: a way past all that prepares a run.
_painters: dict[Function, arguments.Painter] = {}


def _remember_painter(one: Kernel, picture: NDArray[Any], values: tuple[Any, ...]) -> None:
    """Keep the compiled painter that has just run, if it was one, for the next call with such arguments."""
    use = _use("_paint", tuple([v.dtype for v in (picture, *values) if type(v) is np.ndarray]))
    numba = _numba() if use in one.used else None
    if numba is not None:
        signature = tuple(map(numba.typeof, (picture, picture.dtype.type(0), *values)))
        run = one.used[use].get_overload(signature)  # type: ignore[attr-defined]
        form, most = arguments.Form.of((picture, *values)), int(np.iinfo(picture.dtype).max)
        _painters[one.function] = arguments.Painter(run, form, most)


def paint_many(
    function: Function,
    image: NDArray[Any],
    value: Any,
    rows: Any,
    *,
    emits: Emits | None = None,
    stop: Stop | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> None:
    """As ``paint``, once for each row of arguments in ``rows`` (n, number of parameters)."""
    one = kernel(function, emits, flavour)
    _paintable(one)
    table = arguments.table(function, rows)
    picture = _picture(image)
    stop = stop or Stop()
    one.call("_paint_many", (picture, picture.dtype.type(value), stop.flag, table), compiling, stop)
    if picture is not image:
        image[...] = picture


def hits(
    function: Function,
    x: int,
    y: int,
    *args: Any,
    emits: Emits | None = None,
    stop: Stop | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> NDArray[np.int64]:
    """Numbers, from 0, of the emissions that touched the pixel (x, y). Arrays are copied."""
    one = kernel(function, emits, flavour)
    if one.emits not in ("pixels", "coverage", "spans", "fragments"):
        raise ValueError(_("{name} emits no pixels").format(name=one.lowered.name))
    stop = stop or Stop()
    room = 1024
    while True:
        numbers = np.zeros(room, np.int64)
        count, found = np.zeros(1, np.int64), np.zeros(1, np.int64)
        values = arguments.bind(function, args, True)
        one.call("_hits", (int(x), int(y), numbers, count, found, stop.flag, *values), compiling, stop)
        if found[0] <= room:
            return numbers[: found[0]].copy()
        room = int(found[0])


def _paintable(one: Kernel) -> None:
    if one.emits not in PAINTING:
        raise ValueError(
            _("{name} emits nothing that can be painted; collect it").format(name=one.lowered.name)
        )


def _picture(image: NDArray[Any]) -> NDArray[Any]:
    if not isinstance(image, np.ndarray) or image.ndim != 2 or image.dtype.kind not in "iu":
        raise ValueError(_("a picture is an array of integers with rows and columns"))
    return np.ascontiguousarray(image)
