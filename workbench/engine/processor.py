"""LLVM: how it is loaded beside an interface, and what it is told of the processor that it compiles for."""

import ctypes
import functools
import importlib.util
import os
from pathlib import Path


def load_llvm() -> None:
    """Load LLVM's library so that other threads go on meanwhile; an import finds it loaded.

    An import holds all of Python while the system links 180 MB, 60 ms long; a call of the system does not.
    Where there is no such file, nothing is done.
    """
    package = importlib.util.find_spec("llvmlite")
    if os.name == "posix" and package is not None and package.origin is not None:
        for library in Path(package.origin).parent.glob("binding/libllvmlite.*"):
            ctypes.CDLL(None).dlopen(os.fsencode(library), os.RTLD_NOW)


@functools.cache
def mask_short_loops() -> None:
    """Let the vector code of a loop mask its last turn, where the processor can mask every store.

    Otherwise the items left over, up to 31 of them, are done one by one, and rows of a few pixels consist of
    nothing else: triangles of 8 pixels then take 1.6 times as long, short spans 2.7 times. LLVM takes an
    option once only, and leaves the process at one that it does not know: hence the bound on its version.
    """
    from llvmlite import binding

    try:
        features = binding.get_host_cpu_features()
    except RuntimeError:
        return
    if binding.llvm_version_info[0] <= 22 and all(
        features.get(name) for name in ("avx512bw", "avx512dq", "avx512vl")
    ):
        option = "-prefer-predicate-over-epilogue=predicate-else-scalar-epilogue"
        binding.set_option("graphics-workbench", option)
