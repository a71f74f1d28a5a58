#!/usr/bin/env python3
"""Start Graphics Workbench from a checkout, with nothing but Python: it sets up what it needs by itself.

Standard library only. An older Python must be able to read this file as far as the first check, so the syntax
stays that of Python 3.6.
"""

import sys

if sys.version_info < (3, 11):
    sys.exit(
        "Graphics Workbench needs Python 3.11 or newer, and this is Python %d.%d: "
        "install a newer one from python.org or your system's packages, and start run.py with that."
        % sys.version_info[:2]
    )

import ctypes
import hashlib
import json
import os
import re
import shutil
import subprocess
import tomllib
from contextlib import contextmanager
from importlib import metadata
from pathlib import Path

ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
WINDOWS = os.name == "nt"
PYTHON = VENV / ("Scripts/python.exe" if WINDOWS else "bin/python")
LOCK = VENV / ".set-up.lock"
RETRY = "run the same command again to go on"

USAGE = """usage: python3 run.py                  start the program
       python3 run.py test [ARG ...]   run the tests; the arguments go to pytest
       python3 run.py setup            only install what the program needs
       python3 run.py COMMAND ...      list, trace, draw, tour: these need no window

--wheels DIR   with any of these: install from the wheels in DIR, without a network"""

# Said first, so that what is asked for goes before: -n 0 runs the tests one after the other.
ON_ALL_CORES = ["-n", "auto", "--maxprocesses", "4", "--dist", "loadgroup"]

# What needs no display, and the Qt platform plugin it loads all the same (none: it does without Qt).
WITHOUT_WINDOW = {"list": "", "trace": "", "draw": "", "tour": "offscreen", "test": "offscreen"}


class SetUpError(Exception):
    """One sentence for the person at the terminal."""


def say(text):
    print(text, file=sys.stderr, flush=True)


# -- The environment in .venv ------------------------------------------------------------


class Part:
    """What pyproject.toml asks for under one name: the program, or an extra of its dependencies."""

    def __init__(self, name, requirements, megabytes):
        self.name = name
        self.requirements = requirements
        self.megabytes = megabytes
        self.stamp = VENV / f".installed-{name}"
        made_from = json.dumps([requirements, sys.version_info[:2], sys.platform])
        self.fingerprint = hashlib.sha256(made_from.encode()).hexdigest()

    def installed(self):
        """Whether the environment was completed for exactly these requirements."""
        try:
            return PYTHON.exists() and self.stamp.read_text() == self.fingerprint
        except OSError:
            return False


def wanted(extras):
    """The parts that are needed, with at most how many megabytes each is to download."""
    with open(ROOT / "pyproject.toml", "rb") as file:
        declared = tomllib.load(file)
    project = declared["project"]
    sizes = declared["tool"]["graphics-workbench"]["download-megabytes"]
    asked = {"program": project["dependencies"]}
    asked.update((extra, project["optional-dependencies"][extra]) for extra in extras)
    return [Part(name, requirements, sizes[name]) for name, requirements in asked.items()]


@contextmanager
def locked():
    """One set-up at a time; the others wait for it and then find it done."""
    try:
        VENV.mkdir(exist_ok=True)
        file = open(LOCK, "a+")
    except OSError as error:
        raise SetUpError(
            f"The set-up cannot be written to {VENV} ({error.strerror}): copy this folder to where you may "
            "write, and start it there."
        ) from None
    with file:
        if WINDOWS:
            import msvcrt

            def take(wait):
                file.seek(0)
                msvcrt.locking(file.fileno(), msvcrt.LK_LOCK if wait else msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            def take(wait):
                fcntl.flock(file, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)

        try:
            take(wait=False)
        except OSError:
            say("Another set-up is at work in this folder; waiting for it to finish.")
            while True:
                try:
                    take(wait=True)
                    break
                except OSError:  # Windows gives up after ten seconds
                    continue
        yield


def halfway():
    """The records of packages that a stopped pip left without all of their files."""
    for record in [
        *VENV.glob("lib/python*/site-packages/*.dist-info"),
        *VENV.glob("Lib/site-packages/*.dist-info"),
    ]:
        files = metadata.Distribution.at(record).files or []
        paths = [(Path(file.locate()), file.size) for file in files if file.suffix != ".pyc"]
        if not paths or not all(
            path.exists() and size in (None, path.stat().st_size) for path, size in paths
        ):
            yield record


def usable():
    """Whether .venv holds a Python of this version with all of pip."""
    probe = f"import sys, pip; sys.exit(tuple(sys.version_info[:2]) != {sys.version_info[:2]})"
    try:
        answer = subprocess.run([str(PYTHON), "-I", "-c", probe], stderr=subprocess.DEVNULL)
    except OSError:
        return False
    return answer.returncode == 0 and not any(record.name.startswith("pip-") for record in halfway())


def make_environment():
    try:
        import ensurepip  # noqa: F401
        import venv  # noqa: F401
    except ImportError:
        version = ".".join(map(str, sys.version_info[:2]))
        raise SetUpError(
            f"This Python lacks the modules venv and ensurepip: install them (on Debian and Ubuntu: "
            f"sudo apt-get install python{version}-venv) and {RETRY}."
        ) from None
    say(f"Making an environment of its own in {VENV} ...")
    for entry in VENV.iterdir():
        if entry != LOCK:
            remove = shutil.rmtree if entry.is_dir() and not entry.is_symlink() else Path.unlink
            remove(entry)
    if subprocess.call([sys.executable, "-I", "-m", "venv", str(VENV)]) != 0:
        raise SetUpError(f"The environment in {VENV} could not be made; what is wrong stands above.")


def set_up(extras, wheels):
    """Install what is not installed yet; the stamps come last, so that a stopped set-up is gone on with."""
    parts = wanted(extras)
    if all(part.installed() for part in parts):
        return
    with locked():
        missing = [part for part in parts if not part.installed()]
        if not missing:
            return
        if not usable():
            make_environment()
        for record in halfway():
            shutil.rmtree(record)
        count = sum(len(part.requirements) for part in missing)
        if wheels:
            source = ["--no-index", "--find-links", str(wheels)]
            say(f"Installing {count} packages and what they need from {wheels}, no network.")
        else:
            source = []
            megabytes = sum(part.megabytes for part in missing)
            say(
                f"Installing {count} packages and what they need: at most about {megabytes} MB to download, "
                "less what pip has kept from before."
            )
        pip = [str(PYTHON), "-I", "-m", "pip", "install", "--disable-pip-version-check", "--no-input"]
        requirements = [one for part in parts for one in part.requirements]
        if subprocess.call([*pip, *source, *requirements]) != 0:
            hint = (
                f"look into {wheels}" if wheels else "look at the network, or name a folder with --wheels DIR"
            )
            raise SetUpError(f"The packages could not be installed, as pip says above; {hint}, and {RETRY}.")
        for part in parts:
            part.stamp.write_text(part.fingerprint)
        say("The set-up is complete.")


# -- The libraries of the system that Qt needs (Linux) -----------------------------------


def plugin_file(platform):
    """The file of one of Qt's platform plugins, None when this PySide6 has no such plugin."""
    found = VENV.glob(f"lib/python*/site-packages/PySide6/Qt/plugins/platforms/libq{platform}.so")
    return next(found, None)


def lacking(plugin):
    """Names of the shared libraries that are missing for ``plugin``, found by loading it."""
    try:
        ctypes.CDLL(str(plugin))
        return []
    except OSError as error:
        first = str(error).split(":")[0]
    try:
        told = subprocess.run(
            ["ldd", str(plugin)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        missing = re.findall(r"^\s*(\S+) => not found", told.stdout, re.MULTILINE)
    except OSError:
        missing = [first]
    return sorted(set(missing))


def debian_package(library):
    """The Debian package of ``libNAME.so.N`` by Debian's rule for naming them, checked with apt; else ""."""
    name, _, version = library.lower().replace("_", "-").partition(".so.")
    joint = "-" if name[-1].isdigit() else ""
    rule = [name + joint + version, re.sub(r"-(?=\d)", "", name, count=1) + joint + version]
    for candidate in [one + ending for one in rule for ending in ("", "t64")]:
        policy = subprocess.run(["apt-cache", "policy", candidate], stdout=subprocess.PIPE, text=True)
        if re.search(r"Candidate: (?!\(none\))", policy.stdout):
            return candidate
    return ""


def provide_libraries(plugin):
    """Install what ``plugin`` lacks when we may, else tell the one command that does."""
    known, missing = set(), lacking(plugin)
    while missing:
        if not shutil.which("apt-get"):
            raise SetUpError(
                f"Qt needs libraries that this system lacks: {', '.join(missing)}; install their packages."
            )
        root = os.geteuid() == 0
        if root and not known:
            say(f"Qt lacks libraries of the system ({', '.join(missing)}); installing them with apt-get.")
            subprocess.call(["apt-get", "update", "-qq"])
        packages = {debian_package(library) for library in missing} - {""}
        if not packages - known:
            raise SetUpError(
                f"Qt lacks {', '.join(missing)}, which no package known to apt has: try sudo apt-get update."
            )
        install = ["apt-get", "install", "-y", "--no-install-recommends", *sorted(packages)]
        if not root:
            raise SetUpError(
                f"Qt needs libraries that this system lacks. This installs them: sudo {' '.join(install)}"
            )
        known |= packages
        quiet = dict(os.environ, DEBIAN_FRONTEND="noninteractive")
        if (
            subprocess.call([install[0], "-qq", "-o", "DPkg::Lock::Timeout=300", *install[1:]], env=quiet)
            != 0
        ):
            raise SetUpError(
                f"apt-get could not install {' '.join(sorted(packages))}; what is wrong stands above."
            )
        missing = lacking(plugin)


def platform_of(command):
    """The Qt platform plugin that ``command`` will load; "" when it loads none."""
    if command in WITHOUT_WINDOW:
        return WITHOUT_WINDOW[command]
    asked = os.environ.get("QT_QPA_PLATFORM", "").split(";")[0].split(":")[0]
    if asked:
        return asked.replace("-egl", "")
    if os.environ.get("DISPLAY"):
        return "xcb"
    if os.environ.get("WAYLAND_DISPLAY"):
        return "wayland"
    if command == "setup":
        return "offscreen"
    raise SetUpError(
        "There is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set): "
        "python3 run.py tour DIR writes a picture of every workspace without one."
    )


# -- The commands ------------------------------------------------------------------------


def launch(module, arguments):
    """Replace this process by Python running ``module``; away from the current folder's own modules (-P)."""
    command = [str(PYTHON), "-P", "-m", module, *arguments]
    environment = dict(os.environ, PYTHONPATH=str(ROOT))
    if not WINDOWS:
        os.execve(command[0], command, environment)
    return subprocess.call(command, env=environment)


def take_wheels(arguments):
    """The arguments without ``--wheels DIR``, and that folder."""
    rest, wheels = [], None
    words = iter(arguments)
    for word in words:
        if word == "--wheels" or word.startswith("--wheels="):
            wheels = Path(word.partition("=")[2] or next(words, "")).expanduser().resolve()
            if not any(wheels.glob("*.whl")):
                raise SetUpError(f"--wheels names a folder of wheels, and there are none in {wheels}.")
        else:
            rest.append(word)
    return rest, wheels


def main(arguments):
    arguments, wheels = take_wheels(arguments)
    command = arguments[0] if arguments else ""
    if command in ("-h", "--help"):
        print(USAGE)
        return 0
    platform = platform_of(command) if sys.platform.startswith("linux") else ""
    try:
        set_up(["test"] if command == "test" else [], wheels)
    except OSError as error:
        raise SetUpError(
            f"The set-up stopped at {error.filename or VENV} ({error.strerror}): put that right and {RETRY}."
        ) from None
    plugin = plugin_file(platform) if platform else None
    if plugin:
        provide_libraries(plugin)
    if command == "setup":
        return 0
    if command == "test":
        os.chdir(ROOT)
        return launch("pytest", [*ON_ALL_CORES, *arguments[1:]])
    return launch("workbench", arguments)


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except SetUpError as failure:
        say(str(failure))
        sys.exit(1)
    except KeyboardInterrupt:
        say(f"\nStopped; {RETRY}.")
        sys.exit(130)
