"""New ids in a scene, what refers to them included."""

from collections.abc import Callable, Iterator
from typing import Any

from msgspec.structs import replace

from workbench.document.building import with_ids, without_ids
from workbench.document.scene.model import Scene


def with_fresh_ids(scene: Scene, which: Callable[[Any], bool], fresh: Iterator[int]) -> Scene:
    """``scene`` with new ids for the things for which ``which`` is true, and for their parts."""
    renamed: dict[str, str] = {}

    def renewed(thing: Any) -> Any:
        if not which(thing):
            return thing
        new = with_ids(without_ids(thing), fresh, fresh)
        renamed[thing.id] = new.id
        return new

    materials, lights = tuple(map(renewed, scene.materials)), tuple(map(renewed, scene.lights))
    views = tuple(map(renewed, scene.named_views))
    objects = tuple(
        replace(new, material=renamed.get(new.material, new.material)) for new in map(renewed, scene.objects)
    )
    return replace(scene, objects=objects, materials=materials, lights=lights, named_views=views)
