"""Edits of a sheet's scene: its objects and their chains, materials, lights, camera."""

from collections.abc import Sequence
from typing import Any

from msgspec.structs import replace

from workbench.document.addresses import new_ids, sheet_with
from workbench.document.building import (
    Edit,
    checked,
    like,
    numbered,
    plain,
    position,
    remembering,
    scene_with,
    with_sheet,
    with_thing,
    without_ids,
)
from workbench.document.errors import DocumentError
from workbench.document.fields import fields_of, parts_of
from workbench.document.model import Document, Sheet
from workbench.document.motion.model import Motion
from workbench.document.motion.tracks import tracks_of, with_copied_tracks, with_motion
from workbench.document.parts import ids_of_copy
from workbench.document.scene.links import AnyLink3D, Translate3D
from workbench.document.scene.model import Camera, Light, Material, NamedView, Object, Scene
from workbench.document.scene.solids import AnySolid
from workbench.language import _


def _with_scene(document: Document, sheet: Sheet, scene: Scene | None) -> Document:
    return with_sheet(document, replace(sheet, scene=scene))


def object_with(document: Document, identity: str) -> tuple[Sheet, Scene, Object]:
    """The object with this id, its sheet and its scene; raises DocumentError."""
    sheet, scene, thing = scene_with(document, identity)
    if not isinstance(thing, Object):
        sentence = _("{id!r} is not an object of the scene; choose one.")
        raise DocumentError(identity, sentence.format(id=identity))
    return sheet, scene, thing


@checked
def set_scene(sheet: str, scene: Scene | None) -> Edit:
    """Give a sheet a scene, whose ids are new in the document, or take it away."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        after = _with_scene(document, on, None if scene is None else plain(scene))
        return after if on.scene is None else remembering(document, after)

    return edit


@checked
def add_object(sheet: str, thing: Object, index: int | None = None) -> Edit:
    """Put an object into the scene of a sheet, by default after the others.

    Where the scene has no material yet, it gets the first one; an object without one takes the first.
    """

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        scene = on.scene or Scene()
        if not scene.materials:
            (identity,) = new_ids(document, Material.letter, 1)
            scene = replace(scene, materials=(Material(identity, name=_("grey")),))
            document = _with_scene(document, on, scene)
        added = plain(thing if thing.material else replace(thing, material=scene.materials[0].id))
        at = position(len(scene.objects) if index is None else index, len(scene.objects), "scene.objects")
        objects = (*scene.objects[:at], numbered(document, added), *scene.objects[at:])
        return _with_scene(document, sheet_with(document, sheet), replace(scene, objects=objects))

    return edit


@checked
def add_material(sheet: str, material: Material) -> Edit:
    """Put a material into the scene of a sheet."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        scene = on.scene or Scene()
        added = numbered(document, plain(material))
        return _with_scene(document, on, replace(scene, materials=(*scene.materials, added)))

    return edit


@checked
def add_light(sheet: str, light: Light) -> Edit:
    """Put a light into the scene of a sheet."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        scene = on.scene or Scene()
        added = numbered(document, plain(light))
        return _with_scene(document, on, replace(scene, lights=(*scene.lights, added)))

    return edit


@checked
def set_thing(thing: Light | Material) -> Edit:
    """Put a light or a material in place of the one that has its id."""
    return lambda document: with_thing(document, plain(thing))


@checked
def remove_thing(thing: str) -> Edit:
    """Remove an object, a light, a named view, or a material that no object has."""

    def edit(document: Document) -> Document:
        sheet, scene, _thing = scene_with(document, thing)
        kept: dict[str, Any] = {
            name: tuple(each for each in getattr(scene, name) if each.id != thing) for name in parts_of(Scene)
        }
        return remembering(document, _with_scene(document, sheet, replace(scene, **kept)))

    return edit


@checked
def rename_thing(thing: str, name: str) -> Edit:
    """Give an object, a material, a light or a view another name, or none."""
    return lambda document: with_thing(document, replace(scene_with(document, thing)[2], name=name))


@checked
def set_visible(thing: str, visible: bool) -> Edit:
    """Show an object, or hide it."""
    return lambda document: with_thing(document, replace(object_with(document, thing)[2], visible=visible))


@checked
def duplicate_object(thing: str, dx_world: float = 0.0, dy_world: float = 0.0, dz_world: float = 0.0) -> Edit:
    """Put a copy of an object after it, moved by (dx, dy, dz); it gets ids and tracks of its own."""

    def edit(document: Document) -> Document:
        sheet, scene, old = object_with(document, thing)
        bare = without_ids(old)
        if dx_world or dy_world or dz_world:
            moved = plain(Translate3D("", tx=dx_world, ty=dy_world, tz=dz_world))
            bare = replace(bare, transforms=(*bare.transforms, moved))
        at = scene.objects.index(old) + 1
        copy = numbered(document, bare)
        objects = (*scene.objects[:at], copy, *scene.objects[at:])
        document = _with_scene(document, sheet, replace(scene, objects=objects))
        tracks = tracks_of(sheet, (thing,))
        return with_copied_tracks(document, sheet.id, tracks, sheet, ids_of_copy(old, copy))

    return edit


@checked
def move_last_object_as(sheet: str, original: Object, motion: Motion) -> Edit:
    """Let the last object of a scene, a copy, move as ``original`` does in ``motion``.

    A sheet that has no motion yet gets the length and the rate of this one.
    """

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        assert on.scene is not None
        document = with_motion(document, sheet, on.motion or replace(motion, tracks=()))
        there = replace(on, scene=replace(on.scene, objects=(original,)))
        renamed = ids_of_copy(original, on.scene.objects[-1])
        return with_copied_tracks(document, sheet, motion.tracks, there, renamed)

    return edit


@checked
def reorder_object(thing: str, index: int) -> Edit:
    """Move an object to ``index`` in the list of its scene."""

    def edit(document: Document) -> Document:
        sheet, scene, moved = object_with(document, thing)
        others = [other for other in scene.objects if other.id != thing]
        others.insert(position(index, len(others), "scene.objects"), moved)
        return _with_scene(document, sheet, replace(scene, objects=tuple(others)))

    return edit


@checked
def set_solid(thing: str, solid: AnySolid) -> Edit:
    """Make an object another solid; its points stay as far as that one has use for them."""

    def edit(document: Document) -> Document:
        old = object_with(document, thing)[2]
        points = old.points[: solid.most_points]
        after = with_thing(document, replace(old, solid=plain(solid), points=points))
        return after if len(points) == len(old.points) else remembering(document, after)

    return edit


@checked
def set_solid_parameter(thing: str, name: str, value: Any) -> Edit:
    """Set one number or choice of an object's solid."""

    def edit(document: Document) -> Document:
        old = object_with(document, thing)[2]
        declared = fields_of(type(old.solid)).get(name)
        if declared is None or name == "content":
            sentence = _("This solid has no {name!r}; choose one of {names}.")
            names = ", ".join(fields_of(type(old.solid)))
            raise DocumentError(name, sentence.format(name=name, names=names))
        solid = replace(old.solid, **{name: like(declared.kind, value, name)})
        return with_thing(document, replace(old, solid=solid))

    return edit


@checked
def set_material(thing: str, material: str) -> Edit:
    """Let an object have the material with this id."""
    return lambda document: with_thing(document, replace(object_with(document, thing)[2], material=material))


@checked
def add_link(thing: str, link: AnyLink3D, index: int | None = None) -> Edit:
    """Put a link into the chain of an object, by default after the others, so that it acts last."""

    def edit(document: Document) -> Document:
        old = object_with(document, thing)[2]
        chain = old.transforms
        at = position(len(chain) if index is None else index, len(chain), "transforms")
        added = replace(old, transforms=(*chain[:at], plain(link), *chain[at:]))
        return with_thing(document, numbered(document, added))

    return edit


@checked
def remove_link(thing: str, link: str) -> Edit:
    """Take a link out of the chain of an object."""

    def edit(document: Document) -> Document:
        old, at = _link(document, thing, link)
        chain = (*old.transforms[:at], *old.transforms[at + 1 :])
        return remembering(document, with_thing(document, replace(old, transforms=chain)))

    return edit


@checked
def set_link(thing: str, link: AnyLink3D) -> Edit:
    """Put ``link`` in place of the one that has its id."""

    def edit(document: Document) -> Document:
        old, at = _link(document, thing, link.id)
        chain = (*old.transforms[:at], plain(link), *old.transforms[at + 1 :])
        return with_thing(document, replace(old, transforms=chain))

    return edit


@checked
def set_transforms(thing: str, chain: Sequence[AnyLink3D]) -> Edit:
    """Give an object another chain; links without an id get one."""

    def edit(document: Document) -> Document:
        old = object_with(document, thing)[2]
        after = with_thing(document, numbered(document, replace(old, transforms=tuple(map(plain, chain)))))
        kept = {link.id for link in chain}
        gone = any(link.id not in kept for link in old.transforms)
        return remembering(document, after) if gone else after

    return edit


@checked
def reorder_link(thing: str, link: str, index: int) -> Edit:
    """Move a link to ``index`` in its chain: the one at 0 acts first."""

    def edit(document: Document) -> Document:
        old, at = _link(document, thing, link)
        others = [*old.transforms[:at], *old.transforms[at + 1 :]]
        others.insert(position(index, len(others), "transforms"), old.transforms[at])
        return with_thing(document, replace(old, transforms=tuple(others)))

    return edit


def _link(document: Document, thing: str, link: str) -> tuple[Object, int]:
    old = object_with(document, thing)[2]
    for at, each in enumerate(old.transforms):
        if each.id == link:
            return old, at
    sentence = _("Object {thing!r} has no transform {id!r}; it may have been removed.")
    raise DocumentError(f"{thing}/{link}", sentence.format(thing=thing, id=link))


@checked
def set_camera(sheet: str, camera: Camera) -> Edit:
    """Let the scene of a sheet be seen by ``camera``; so *Keep this view* keeps what was only looked at."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        return _with_scene(document, on, replace(on.scene or Scene(), camera=plain(camera)))

    return edit


@checked
def add_named_view(sheet: str, camera: Camera, name: str) -> Edit:
    """Keep a camera under a name, after the other views of the scene."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        scene = on.scene or Scene()
        view = numbered(document, plain(NamedView("", camera, name)))
        return _with_scene(document, on, replace(scene, named_views=(*scene.named_views, view)))

    return edit
