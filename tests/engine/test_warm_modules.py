"""Texts that are in no entry are prepared by the module that has them."""

from types import SimpleNamespace

import pytest

from workbench.display import face_kernels
from workbench.engine import warm


def test_the_child_lets_a_module_compile_its_texts(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked: list[str] = []

    def stand_in(name: str) -> SimpleNamespace:
        return SimpleNamespace(compile_all=lambda: asked.append(name))

    monkeypatch.setattr(warm, "import_module", stand_in)
    monkeypatch.setattr(warm.os, "nice", lambda _more: 0)
    assert warm.main(["collect", "some.texts"]) == 0
    assert asked == ["some.texts"]
    assert capsys.readouterr().out.split() == ["1", "1", "some.texts", "run"]


def test_a_module_is_loaded_only_when_it_was_compiled_before(monkeypatch: pytest.MonkeyPatch) -> None:
    compiled: list[str] = []
    monkeypatch.setattr(face_kernels, "compile_all", lambda: compiled.append("all"))
    name = face_kernels.__name__
    for ready, stopped, runs in ((False, False, 0), (True, True, 0), (True, False, 1)):
        monkeypatch.setattr(warm.compiled, "ready", lambda _text, _use, now=ready: now)
        assert warm.module_is_warm(name) == ready
        warm.load_module(name, lambda now=stopped: now)
        assert len(compiled) == runs


def test_the_tube_s_texts_are_at_hand_only_when_all_of_them_have_run(monkeypatch: pytest.MonkeyPatch) -> None:
    face_kernels.compile_all()
    assert face_kernels.at_hand()
    missing = face_kernels.TEXTS[-1]
    monkeypatch.setattr(face_kernels, "known", lambda text, _use: text is not missing)
    assert not face_kernels.at_hand()
