"""The scene as a value: addresses, edits, what is refused, and what a file keeps of it."""

import json
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

from tests.document.scene.scenes import full_document, full_scene
from workbench.algorithms import solids
from workbench.document import DocumentError, Stored, edits, load, save
from workbench.document.addresses import changed, declared_at, parse, resolve
from workbench.document.check import MAX_VIEWS, check
from workbench.document.fields import Number, fields_of, numbers_of, structs_in
from workbench.document.identities import ids
from workbench.document.model import Document
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene import edits as scene_edits
from workbench.document.scene import laws
from workbench.document.scene.links import AnyLink3D, Rotate3D, Scale3D, Translate3D
from workbench.document.scene.meshes import blob_of, mesh_of
from workbench.document.scene.model import Camera, Light, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, Extrusion, MeshSolid, Sphere, Surface
from workbench.document.state import SessionState
from workbench.document.storage.blobs import Blob
from workbench.document.storage.files import decode, encode
from workbench.document.storage.renumbering import with_room
from workbench.exchange.reading import Job, Reading
from workbench.geometry.meshes import face_normals

SHEET = blank_sheet().sheets[0].id


def scene_of(document: Document) -> Scene:
    scene = document.sheets[0].scene
    assert scene is not None
    return scene


def numbers_in(holder: Any, address: str) -> Iterator[tuple[str, Number, Any]]:
    for name, (kind, many) in fields_of(type(holder)).items():
        value = getattr(holder, name)
        for index, entry in enumerate(value) if many else [(None, value)]:
            here = f"{address}{name}" if index is None else f"{address}{name}.{index}"
            if isinstance(kind, Number):
                yield here, kind, entry
            elif kind is msgspec.Struct:
                top = isinstance(holder, Scene)
                part = f"{SHEET}/{entry.id}/" if top and many else many and f"{address}{entry.id}/"
                yield from numbers_in(entry, part or f"{here}.")


NUMBERS = list(numbers_in(full_scene(), f"{SHEET}/scene."))


def test_every_number_of_a_scene_is_declared_and_somewhere() -> None:
    kinds = {kind for kind in structs_in(Scene) if numbers_of(kind)}
    assert len(kinds) > 25
    assert len({address for address, *_rest in NUMBERS}) == len(NUMBERS) > 150


@pytest.mark.parametrize(
    "kind", [k for k in structs_in(Scene) if numbers_of(k)], ids=lambda kind: kind.__name__
)
def test_every_number_of_a_scene_says_what_it_may_be(kind: type) -> None:
    for name, number in numbers_of(kind).items():
        assert number.label, name
        assert math.isfinite(number.low) and math.isfinite(number.high), name  # noqa: PT018
        assert number.low < number.high


# These are bounded by another number too, so that one more may be refused.
BOUND = ("thickness", "rows", "u_degree", "v_degree")


@pytest.mark.parametrize(("address", "number", "value"), NUMBERS, ids=[each[0] for each in NUMBERS])
def test_a_number_has_one_address(address: str, number: Number, value: Any) -> None:
    document = check(full_document())
    assert declared_at(document, address).kind is number
    assert resolve(document, address) == value
    low, high = (int, int) if number.whole else (float, float)
    for beyond in (low(number.low) - 1, high(number.high) * 2 + 1):
        with pytest.raises(DocumentError) as refusal:
            edits.set_attribute(address, beyond)(document)
        assert refusal.value.short.startswith(f"The {number.label} is ")
    step = 0.125 if address.rpartition(".")[2] in BOUND and not number.whole else 1
    other = value + step if value + step <= number.high else value - 1 if number.whole else value / 2
    if address.rpartition(".")[2] in BOUND and number.whole:
        other = value if value == 3 else value - 1
    after = edits.set_attribute(address, other)(document)
    if other == value:
        return
    assert changed(document, after) == {parse(address)}
    assert resolve(after, address) == other


def test_ids_are_unique_over_figures_and_scenes() -> None:
    document = check(full_document())
    every = [identity for _field, identity in ids(document)]
    assert {"m1", "l1", "t6", "sp8"} <= set(every)
    scene = scene_of(document)
    twice = replace(scene, lights=(Light("t6"),))
    with pytest.raises(DocumentError, match="is 't6', which another one already has"):
        check(replace(document, sheets=(replace(document.sheets[0], scene=twice),)), document)


def test_a_scene_is_built_by_edits() -> None:
    document = blank_sheet()
    assert document.sheets[0].scene is None
    document = scene_edits.add_object(SHEET, Object("", Box(), "", name="box"))(document)
    document = scene_edits.add_light(SHEET, Light(""))(document)
    document = scene_edits.add_material(SHEET, Material("", "gold", 0xFFD700))(document)
    scene = scene_of(document)
    (box,), (grey, gold), (light,) = scene.objects, scene.materials, scene.lights
    assert box.material == grey.id
    assert len({box.id, grey.id, gold.id, light.id}) == 4
    document = scene_edits.set_material(box.id, gold.id)(document)
    with pytest.raises(DocumentError, match="has no such material"):
        scene_edits.remove_thing(gold.id)(document)
    document = scene_edits.remove_thing(grey.id)(document)
    document = scene_edits.set_solid_parameter(box.id, "width", np.float32(5))(document)
    with pytest.raises(DocumentError, match="width is -1"):
        scene_edits.set_solid_parameter(box.id, "width", -1)(document)
    with pytest.raises(DocumentError, match=r"has no 'radius'; choose one of width, height, depth\."):
        scene_edits.set_solid_parameter(box.id, "radius", 1)(document)
    document = scene_edits.duplicate_object(box.id, 3.0)(document)
    document = scene_edits.set_visible(box.id, False)(document)
    document = scene_edits.rename_thing(box.id, "old")(document)
    first, second = scene_of(document).objects
    assert (first.name, first.visible, second.name, second.visible) == ("old", False, "box", True)
    assert second.matrix is not None
    assert second.matrix[:, 3].tolist() == [3, 0, 0, 1]
    document = scene_edits.reorder_object(second.id, 0)(document)
    assert [each.id for each in scene_of(document).objects] == [second.id, first.id]
    document = scene_edits.set_camera(SHEET, Camera("isometric"))(document)
    assert scene_of(document).camera.projection == "isometric"
    gone = scene_edits.remove_thing(second.id)(document)
    again = scene_edits.add_object(SHEET, Object("", Sphere(), ""))(gone)
    assert scene_of(again).objects[-1].id not in [identity for _field, identity in ids(document)]


def test_links_act_in_their_order_and_can_be_switched_off() -> None:
    document = scene_edits.add_object(SHEET, Object("", Box(), ""))(blank_sheet())
    (box,) = scene_of(document).objects
    document = scene_edits.add_link(box.id, Translate3D("", tx=1.0))(document)
    document = scene_edits.add_link(box.id, Rotate3D("", angle=90.0, y_axis=0.0, z_axis=1.0))(document)

    def origin() -> list[float]:
        matrix = scene_of(document).objects[0].matrix
        return [0.0, 0.0, 0.0] if matrix is None else matrix[:3, 3].round(12).tolist()

    move, turn = (link.id for link in scene_of(document).objects[0].transforms)
    assert origin() == [0, 1, 0]
    document = scene_edits.reorder_link(box.id, turn, 0)(document)
    assert origin() == [1, 0, 0]
    document = edits.set_attribute(f"{SHEET}/{box.id}/{move}/on", False)(document)
    assert origin() == [0, 0, 0]
    document = scene_edits.set_link(box.id, Translate3D(move, ty=4.0))(document)
    assert origin() == [0, 4, 0]
    document = scene_edits.remove_link(box.id, move)(document)
    assert len(scene_of(document).objects[0].transforms) == 1
    with pytest.raises(DocumentError, match="has no transform"):
        scene_edits.remove_link(box.id, move)(document)


def test_the_axis_of_the_worked_example() -> None:
    axis = Rotate3D("t1", angle=90.0, x_pivot=1.0, z_pivot=1.0, x_axis=1.0, y_axis=2.0, z_axis=2.0)
    turned = axis.matrix @ [3.0, 1.0, 1.0, 1.0]
    assert turned[:3] == pytest.approx([0.7778, 2.2222, 0.8889], abs=5e-5)
    assert np.linalg.multi_dot([part.matrix for part in reversed(axis.unfolded())]) == pytest.approx(
        axis.matrix
    )


def no_scene(change: Callable[[Scene], Scene]) -> None:
    document = full_document()
    check(replace(document, sheets=(replace(document.sheets[0], scene=change(scene_of(document))),)))


def seen_by(**fields: Any) -> Callable[[Scene], Scene]:
    return lambda scene: replace(scene, camera=replace(scene.camera, **fields))


def first(**fields: Any) -> Callable[[Scene], Scene]:
    return lambda scene: replace(scene, objects=(replace(scene.objects[0], **fields), *scene.objects[1:]))


def linked(link: AnyLink3D) -> Callable[[Scene], Scene]:
    return first(transforms=(link,))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (seen_by(near=5.0, far=5.0), "camera sees nothing .*near plane is at 5 and the far plane at 5"),
        (seen_by(near=5.0, far=2.0, projection="cabinet"), "give near < far"),
        (seen_by(look_at=Point3D(1.0, 2.0, 9.0)), "camera sees nothing .*eye is at the point it looks at"),
        (seen_by(look_at=Point3D(1.0, 2.0, 9.0), projection="isometric"), "eye is at the point"),
        (seen_by(up=Point3D(1.0, 2.0, 9.0)), "up runs along the line of sight"),
        (seen_by(up=Point3D(0.0, 0.0, 0.0)), "camera has no up direction"),
        (seen_by(up=Point3D(0.0, 0.0, 0.0), projection="isometric"), "camera has no up direction"),
        (seen_by(projection="matrix", entries=(1.0,) * 16), "matrix of the camera is singular"),
        (seen_by(projection="matrix", entries=(1.0,) * 9), "has 9 of at least 16"),
        (seen_by(projection="fish eye"), "projection is 'fish eye'; choose one of orthographic"),
        (seen_by(projection="oblique", oblique_alpha=0.0), "must lie between 0 and 180"),
        (first(material="m9"), r"objects\[0\]\.material is 'm9', but the scene has no such material"),
        (first(solid=Extrusion()), r"objects\[0\]\.points has 0 entries, and this solid needs 3 to 2000"),
        (linked(Scale3D("t1", sx=math.nan)), "sx is nan"),
        (linked(Rotate3D("t1", y_axis=0.0)), r"transforms cannot be worked out \("),
        (linked(Scale3D("t1", sx=1e6, sy=1e6)), ""),
        (first(solid=MeshSolid(Blob(b"no mesh"))), "solid cannot be made .the content is not a mesh"),
        (first(solid=MeshSolid(b"bytes")), r"solid\.content is not the content of a file"),  # type: ignore[arg-type]
        (first(solid=Box(width=0.0)), "width is 0.0; give a number between 1e-06 and"),
    ],
)
def test_what_is_no_scene_is_refused_in_one_sentence(change: Callable[[Scene], Scene], said: str) -> None:
    if not said:
        no_scene(change)
        return
    with pytest.raises(DocumentError, match=said) as refusal:
        no_scene(change)
    assert str(refusal.value).startswith("sheets[0].scene.")
    assert str(refusal.value).endswith(".")


def test_a_surface_needs_whole_rows() -> None:
    scene = full_scene()
    bent = replace(scene.objects[-1], solid=Surface(2))
    with pytest.raises(DocumentError, match="9 points do not make 2 rows of equal length"):
        no_scene(lambda _scene: replace(scene, objects=(*scene.objects[:-1], bent)))


# Files


def test_a_file_keeps_a_scene_and_says_nothing_where_there_is_none(tmp_path: Path) -> None:
    document = full_document()
    save(document, tmp_path / "a.gwb")
    assert load(tmp_path / "a.gwb") == document
    text = json.loads((tmp_path / "a.gwb").read_text())
    (digest,) = text["blobs"]
    contents = [o["solid"].get("content") for o in text["document"]["sheets"][0]["scene"]["objects"]]
    assert [c for c in contents if c] == [digest]
    assert b'"scene"' not in encode(Stored(blank_sheet()))
    mesh = scene_of(load(tmp_path / "a.gwb")).objects[12].mesh
    assert np.array_equal(mesh.vertices, solids.icosahedron().vertices)
    assert [f.tolist() for f in mesh.faces] == [f.tolist() for f in solids.icosahedron().faces]


def test_the_content_of_a_mesh_is_kept_once_and_gone_with_its_last_object(tmp_path: Path) -> None:
    document = scene_edits.duplicate_object("o12")(full_document())
    stored = decode(encode(Stored(document)))
    assert stored.blobs == {}
    one, two = (o.solid for o in scene_of(stored.document).objects if isinstance(o.solid, MeshSolid))
    assert one == two
    bare = scene_edits.set_scene(SHEET, None)(stored.document)
    assert b'"blobs": {}' in encode(Stored(bare))


def test_a_file_without_the_content_of_a_mesh_is_refused() -> None:
    text = json.loads(encode(Stored(full_document())))
    text["blobs"] = {}
    with pytest.raises(DocumentError, match=r"objects\[12\]\.solid\.content is not in the file"):
        decode(json.dumps(text).encode())
    text["document"]["sheets"][0]["scene"]["objects"][12]["solid"]["content"] = "abc"
    with pytest.raises(DocumentError, match="digest"):
        decode(json.dumps(text).encode())


def test_the_child_reads_a_picture_with_a_scene(tmp_path: Path) -> None:
    stored = Stored(full_document())
    (tmp_path / "a.gwb").write_bytes(encode(stored))
    assert Reading(Job("picture", str(tmp_path / "a.gwb"))).follow() == stored


def test_a_sheet_with_a_scene_comes_in_beside_another() -> None:
    document = full_document()
    sheet = replace(document.sheets[0], name="again")
    both = edits.add_sheet(sheet)(document)
    scene = both.sheets[1].scene
    assert scene is not None
    assert {o.material for o in scene.objects} == {m.id for m in scene.materials} != {"m1"}
    assert len(list(ids(both))) == len({identity for _field, identity in ids(both)})


def test_ids_that_are_too_high_are_given_anew_in_scenes_too() -> None:
    document = full_document()
    scene = scene_of(document)
    high = replace(scene, lights=(Light("l999999999999999"),))
    document = replace(document, sheets=(replace(document.sheets[0], scene=high),))
    renewed, _state = with_room(document, SessionState())
    assert check(renewed) is renewed
    assert max(int("".join(filter(str.isdigit, i)) or 0) for _f, i in ids(renewed)) < 1000


@pytest.mark.parametrize(
    "damage", [lambda b: b[:-1], lambda b: b[:40], lambda b: b"x" + b[1:], lambda b: b + b"\0"]
)
def test_a_damaged_mesh_is_refused(damage: Callable[[bytes], bytes]) -> None:
    with pytest.raises(ValueError, match="not a mesh, or it is damaged"):
        mesh_of(Blob(damage(blob_of(solids.cube()))))


def test_every_object_of_the_full_scene_has_faces_with_area() -> None:
    for thing in full_scene().objects:
        assert (np.abs(face_normals(*thing.mesh)).sum(axis=1) > 0).all()


def test_a_named_view_is_kept_renamed_removed_and_saved(tmp_path: Path) -> None:
    document = check(full_document())
    camera = Camera(projection="cabinet", eye=Point3D(0.0, 0.0, 7.0))
    after = scene_edits.add_named_view(SHEET, camera, "front")(document)
    aside, front = scene_of(after).named_views
    assert (aside.name, front.name, front.camera) == ("aside", "front", camera)
    after = scene_edits.rename_thing(front.id, "yard")(after)
    save(after, tmp_path / "a.gwb")
    assert scene_of(load(tmp_path / "a.gwb")).named_views == scene_of(after).named_views
    address = f"{SHEET}/{front.id}/camera.eye.z"
    assert resolve(after, address) == 7.0
    assert changed(after, edits.set_attribute(address, 8.0)(after)) == {parse(address)}
    gone = scene_edits.remove_thing(aside.id)(after)
    assert [view.name for view in scene_of(gone).named_views] == ["yard"]
    assert gone.last_id >= after.last_id
    twice = edits.add_sheet(gone.sheets[0])(gone)
    assert len({identity for _field, identity in ids(twice)}) == len(list(ids(twice)))


def test_a_named_view_that_sees_nothing_is_refused() -> None:
    blind = replace(Camera(), eye=Point3D(0.0, 0.0, 0.0))
    with pytest.raises(DocumentError, match="sees nothing"):
        scene_edits.add_named_view(SHEET, blind, "")(check(full_document()))
    document, most = full_document(), MAX_VIEWS
    scene = scene_of(document)
    full = replace(scene, named_views=tuple(replace(scene.named_views[0], id=f"n{k}") for k in range(most)))
    document = replace(document, sheets=(replace(document.sheets[0], scene=full),))
    with pytest.raises(DocumentError, match="named_views"):
        scene_edits.add_named_view(SHEET, Camera(), "one more")(check(document))


def test_a_scene_has_only_so_many_triangles_in_all(monkeypatch: pytest.MonkeyPatch) -> None:
    ball = Object("", Sphere(slices=10, stacks=5), "", "ball")  # 80: two caps of 10, and 3 rings of 10 quads
    mesh = Object("", MeshSolid(blob_of(solids.box(1, 1, 1))), "", "mesh")  # 12
    monkeypatch.setattr(laws, "MOST_TRIANGLES", 80 + 12 + 80)
    document = blank_sheet()
    for thing in (ball, mesh, ball):
        document = scene_edits.add_object(SHEET, thing)(document)
    assert [thing.triangle_count for thing in scene_of(document).objects] == [80, 12, 80]
    file = encode(Stored(document))
    assert decode(file).document == document
    first = scene_of(document).objects[0].id
    for edit in (
        scene_edits.add_object(SHEET, mesh),
        edits.set_attribute(f"{SHEET}/{first}/solid.slices", 11),
    ):
        with pytest.raises(DocumentError, match=r"objects has 18[04] triangles in all, but .* at most 172;"):
            edit(document)
    monkeypatch.setattr(laws, "MOST_TRIANGLES", 171)
    with pytest.raises(DocumentError, match="has 172 triangles in all"):
        decode(file)
    fewer = edits.set_attribute(f"{SHEET}/{first}/solid.slices", 9)(document)
    assert scene_of(fewer).objects[0].triangle_count == 72
