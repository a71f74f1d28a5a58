"""A vertex of the scene as the subject of a run: the same point that the picture has."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.document.errors import DocumentError
from workbench.document.samples.examples import blank_sheet, example
from workbench.document.scene.looking import kinds, projecting
from workbench.document.subjects import Subject
from workbench.rendering.scene.around import window_of
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Viewpoint
from workbench.rendering.subjects.projection import seen_from
from workbench.rendering.subjects.registry import calls_of, checked

SHEET = example("space-house").document.sheets[0]


@pytest.mark.parametrize("slug", [kind.slug for kind in kinds()])
@pytest.mark.parametrize("around", [False, True])
def test_the_run_ends_where_the_picture_has_the_vertex(slug: str, around: bool) -> None:
    assert SHEET.scene is not None
    camera = projecting(SHEET.scene.camera, slug, 5.0)
    # Whether the document has the camera, or somebody looks around with it.
    sheet = SHEET if around else replace(SHEET, scene=replace(SHEET.scene, camera=camera))
    assert sheet.scene is not None
    size = sheet.width_px, sheet.height_px
    every = np.concatenate([mesh.vertices for mesh, *_rest in placed(sheet.scene)])
    view = Viewpoint.of(camera, size, window_of(sheet.scene.camera, size, every), every)
    for number, thing in enumerate(sheet.scene.objects):
        vertices = placed(sheet.scene)[number][0].vertices
        for vertex in (0, len(vertices) - 1):
            seen = seen_from(camera) if around else {}
            subject = Subject("projection", (thing.id,), arguments={"vertex": vertex, **seen})
            (call,) = calls_of(sheet, checked(subject))
            steps = list(call.entry.function(*call.arguments))
            assert steps[0][:3] == pytest.approx(tuple(vertices[vertex]))
            x, y, z, w = view.homogeneous(vertices[[vertex]])[0]
            device = view.device
            expected = x / w * device[0, 0] + device[0, 2], y / w * device[1, 1] + device[1, 2], z / w
            assert steps[-1][:3] == pytest.approx(expected)


def test_without_an_object_there_is_nothing_to_run() -> None:
    assert calls_of(blank_sheet().sheets[0], Subject("projection")) == []
    # One that has gone is the first that there is, a vertex beyond the last is the last.
    (call,) = calls_of(SHEET, Subject("projection", ("o9",), arguments={"vertex": 99}))
    assert SHEET.scene is not None
    assert call.arguments[-1].tolist() == SHEET.scene.objects[0].mesh.vertices[-1].tolist()


def test_only_whole_numbers_name_a_vertex() -> None:
    for bad in (-1, 0.5, "first"):
        with pytest.raises(DocumentError):
            checked(Subject("projection", arguments={"vertex": bad}))
