"""Pictures of a scene that are asked for while one is drawn: the last one is drawn, and not after minutes."""

import threading
from typing import cast

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.engine.stopping import Stop, Stopped
from workbench.panels.space import scene_worker
from workbench.panels.space.scene_worker import SceneAnswer, SceneJob, SceneWorker
from workbench.rendering.scene.edge_picture import EdgePicture

JOBS = [SceneJob(Scene(), (size, size), Rectangle(0.0, 0.0, 1.0, 1.0), "faces") for size in (8, 16, 24)]


def test_a_picture_that_takes_long_gives_way_to_the_last_one_asked_for(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun: list[SceneJob] = []
    never, picture = threading.Event(), cast(EdgePicture, "a picture")

    def answer(job: SceneJob, stop: Stop) -> SceneAnswer:
        begun.append(job)
        while job is JOBS[0]:  # until it is stopped
            if stop.is_set:
                raise Stopped
            never.wait(0.005)
        return SceneAnswer(job, picture)

    monkeypatch.setattr(scene_worker, "_answer", answer)
    monkeypatch.setattr(scene_worker, "PATIENCE_S", 0.05)
    worker = SceneWorker()
    told: list[tuple[object, ...]] = []
    worker.drawn.connect(lambda *answer: told.append(answer))
    worker.failed.connect(lambda *answer: told.append(answer))
    for job in JOBS:
        worker.ask(job)
    qtbot.waitUntil(lambda: not worker.busy, timeout=20_000)
    assert begun == [JOBS[0], JOBS[2]]
    assert told == [(JOBS[2], picture)]  # and no word of the one that gave way
