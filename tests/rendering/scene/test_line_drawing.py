"""Line drawings of scenes: what is left of the wireframe, and where it goes."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.document.model import Rectangle
from workbench.document.samples.arena import arena_examples
from workbench.document.scene.model import Camera, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, Sphere
from workbench.rendering.scene import line_drawing as drawings
from workbench.rendering.scene import wireframe
from workbench.rendering.scene.edge_picture import edge_picture
from workbench.rendering.scene.line_drawing import drawn_at_once, line_drawing, line_picture, scene_strokes

GREY = (Material("m1", colour=0x336699),)


def scene_of(*solids):
    objects = tuple(Object(f"o{k}", solid, "m1") for k, solid in enumerate(solids, 1))
    return Scene(objects, GREY, (), Camera(eye=Point3D(4.0, 5.0, 7.0)))


def length(segments):
    return float(np.hypot(*(segments[:, 2:] - segments[:, :2]).T).sum())


def test_a_box_shows_nine_of_its_twelve_edges_and_they_are_those_of_the_wireframe():
    scene = scene_of(Box())
    all_edges, seen = wireframe(scene), line_drawing(scene)
    assert (len(all_edges), len(seen.table)) == (12, 9)
    either = {tuple(np.round(row, 9)) for row in np.concatenate([all_edges, all_edges[:, [2, 3, 0, 1]]])}
    assert all(tuple(np.round(row, 9)) in either for row in seen.table)


def test_what_stands_before_hides_what_is_behind():
    alone, both = scene_of(Sphere(0.5)), scene_of(Sphere(0.5), Box(3.0, 3.0, 3.0))
    assert len(line_drawing(alone).table)
    assert set(line_drawing(both).of.tolist()) == {1}


def test_what_the_near_plane_cuts_is_drawn_as_far_as_it_is_seen():
    scene = scene_of(Box(8.0, 8.0, 8.0))
    near = replace(scene, camera=replace(scene.camera, near=6.0))
    assert np.isfinite(line_drawing(near).table).all()
    assert 0 < length(line_drawing(near).table) <= length(wireframe(near)) + 1e-9


def test_a_vector_tube_gets_the_lines_that_are_seen_in_the_colour_of_their_material():
    sheet = arena_examples()[-1].document.sheets[0]
    strokes = scene_strokes(sheet)
    assert len(strokes) == len(line_drawing(sheet.scene).table)
    assert {colour for *_ends, colour in strokes} == {sheet.scene.materials[0].colour}
    for x0, y0, x1, y1, _colour in strokes:
        assert 0 <= min(x0, x1) <= max(x0, x1) <= sheet.width_px
        assert 0 <= min(y0, y1) <= max(y0, y1) <= sheet.height_px
    assert scene_strokes(replace(sheet, scene=None)) == []
    assert scene_strokes(replace(sheet, scene=Scene())) == []


def test_too_many_edges_and_faces_are_refused_in_a_sentence_and_all_lines_are_shown(monkeypatch):
    scene = scene_of(Sphere())
    monkeypatch.setattr(drawings, "MOST_PAIRS", 1_000)
    with pytest.raises(
        ValueError, match="edges and 528 triangles, too many to compare each with every other"
    ):
        line_drawing(scene)
    monkeypatch.setattr(drawings, "MOST_PAIRS_PLAIN", 1_000)
    monkeypatch.setattr(drawings, "MOST_PAIRS_AT_ONCE", 1_000)
    assert drawn_at_once(scene) is None
    sheet = replace(arena_examples()[-1].document.sheets[0], scene=scene)
    assert len(scene_strokes(sheet)) == len(wireframe(scene))


def test_on_the_screen_the_lines_lie_where_the_edges_do():
    hidden_one = replace(Object("o9", Box(), "m1"), visible=False)
    scene = scene_of(Box())
    scene = replace(scene, objects=(hidden_one, *scene.objects))
    window = Rectangle(-3.0, -2.0, 3.0, 2.0)
    lines = line_picture(line_drawing(scene), scene, (300, 200), window)
    edges = edge_picture(scene, (300, 200), window, faces=False)
    ends = {tuple(np.round(end, 6)) for row in edges.seen for end in (row[:2], row[2:])}
    assert (len(lines.seen), set(lines.seen_of.tolist())) == (9, {1})
    assert all(tuple(np.round(end, 6)) in ends for row in lines.seen for end in (row[:2], row[2:]))
