"""What the operating system is asked."""

import ctypes
import os
import subprocess
import sys
from functools import partial

import pytest

from workbench import paths
from workbench.paths import alive


def test_a_process_is_alive_until_it_has_ended() -> None:
    child = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    assert alive(child.pid)
    assert alive(os.getpid())
    child.communicate(b"\n")
    assert not alive(child.pid)
    assert alive(10**30)  # no number of a process: nothing is swept for it


class Kernel:
    """What Windows documents of these functions, over a table of processes."""

    def __init__(self, running: dict[int, bool], closed: set[int]) -> None:
        self.running, self.closed, self.handles, self.error = running, closed, [], 0
        self.OpenProcess = partial(self._open)  # which takes attributes, as a function of ctypes does

    def _open(self, access: int, _inherit: bool, process: int) -> int:
        assert access == 0x00100000
        if process in self.closed or process not in self.running:
            self.error = 5 if process in self.closed else 87
            return 0
        self.handles.append(process)
        return process

    def WaitForSingleObject(self, handle: ctypes.c_void_p, milliseconds: int) -> int:
        assert milliseconds == 0
        return 0x102 if self.running[handle.value] else 0

    def CloseHandle(self, handle: ctypes.c_void_p) -> None:
        self.handles.remove(handle.value)


@pytest.mark.parametrize(("process", "there"), [(11, True), (12, False), (13, True), (14, False)])
def test_windows_is_asked_without_ending_the_process(
    monkeypatch: pytest.MonkeyPatch, process: int, there: bool
) -> None:
    kernel = Kernel({11: True, 12: False}, {13})
    monkeypatch.setattr(paths.sys, "platform", "win32")
    monkeypatch.setattr(ctypes, "WinDLL", lambda _name, use_last_error: kernel, raising=False)
    monkeypatch.setattr(ctypes, "get_last_error", lambda: kernel.error, raising=False)
    monkeypatch.setattr(os, "kill", None)  # there it ends the process
    assert alive(process) == there
    assert kernel.handles == []
