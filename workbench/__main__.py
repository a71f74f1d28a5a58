"""Where the program starts: a command without a window, or the window. Imports either only then."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command in ``arguments`` (default: those of the process) and return its exit status."""
    try:
        return _run(sys.argv[1:] if arguments is None else list(arguments))
    except KeyboardInterrupt:  # while something is imported, too
        return 130


def _run(words: list[str]) -> int:
    # The matrices here are small: threads of the linear algebra would only wait for one another.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    if _opens_a_window(words):
        from workbench.shell.start import start

        return start(words)
    if words[0] == "tour":
        from workbench.shell.tour import main as tour

        return tour(words[1:])
    from workbench import cli

    return cli.main(words)


def _opens_a_window(words: Sequence[str]) -> bool:
    """No command is given: nothing at all, options of the window, or a file to open."""
    if not words:
        return True
    if words[0].startswith("-"):
        return words[0] not in ("-h", "--help", "--version")
    from workbench.exchange.readable import kind_of

    return bool(kind_of(Path(words[0])))


if __name__ == "__main__":
    sys.exit(main())
