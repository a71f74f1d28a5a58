"""How a chain is changed and what its cards say: that of a figure in the plane, and of an object in space."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol

from msgspec.structs import replace

from workbench.document.addresses import parse
from workbench.document.building import Edit
from workbench.document.scene.edits import add_link, remove_link, reorder_link, set_link
from workbench.document.scene.links import (
    Affine3D,
    AnyLink3D,
    Reflect3D,
    Rotate3D,
    Scale3D,
    Shear3D,
    Translate3D,
)
from workbench.document.transforms.edits import (
    add_transform,
    remove_transform,
    reorder_transform,
    switch_transform,
)
from workbench.document.transforms.links import (
    Affine,
    AnyLink,
    Link,
    Reflect,
    Rotate,
    Scale,
    Shear,
    Translate,
)
from workbench.document.transforms.stages import stages
from workbench.language import _
from workbench.panels.transform.told import caption, in_numbers

Pivot = tuple[float, float]
Offer = tuple[str, Callable[[Pivot], Link]]
"""What can be added: its title, and the link about a pivot where it has one."""


class StageWords(NamedTuple):
    """One matrix of a link: its number in the chain from 1, its name, its numbers, what it does."""

    number: int
    name: str
    numbers: str
    words: str


class ChainEdits(Protocol):
    """What a dock of cards asks of the chains of one kind of thing, named by its id; links are named by their
    addresses. ``bare`` is said of a thing without a chain, ``none`` where there is no such thing.
    """

    none: str
    bare: str

    def offers(self) -> Sequence[Offer]:
        """What can be put at the end of a chain; the second one is what a chain is begun with."""

    def stages(self, chain: Sequence[Any]) -> dict[str, list[StageWords]]:
        """The matrices of each link that is on, by its id."""

    def add(self, thing: str, link: Any) -> Edit:
        """Put a link at the end."""

    def switch(self, address: str, link: Any, on: bool) -> Edit:
        """A link on or off."""

    def remove(self, address: str) -> Edit:
        """Take a link away."""

    def reorder(self, address: str, index: int) -> Edit:
        """Let a link act as the one at ``index``."""


class FigureChain:
    """The chain of a figure."""

    none = _("Draw or select a figure to transform it.")
    bare = _("This figure is as it was drawn.")

    def offers(self) -> Sequence[Offer]:
        """Every kind, mirrors in the usual lines too."""
        return (
            (_("Translation"), lambda _p: Translate("", tx=2.0, ty=1.0)),
            (_("Rotation about the pivot"), lambda p: Rotate("", angle=45.0, x_pivot=p[0], y_pivot=p[1])),
            (_("Scaling about the pivot"), lambda p: Scale("", sx=1.5, sy=1.5, x_pivot=p[0], y_pivot=p[1])),
            (_("Reflection in the x axis"), lambda _p: Reflect("", angle=0.0)),
            (_("Reflection in the y axis"), lambda _p: Reflect("", angle=90.0)),
            (_("Reflection in the origin"), lambda _p: Reflect("", mirror="point")),
            (_("Reflection in the line y = x"), lambda _p: Reflect("", angle=45.0)),
            (
                _("Reflection in a line through the pivot"),
                lambda p: Reflect("", angle=30.0, x_pivot=p[0], y_pivot=p[1]),
            ),
            (_("Shear along x"), lambda _p: Shear("", sh_x=0.5)),
            (_("Shear along y"), lambda _p: Shear("", sh_y=0.5)),
            (_("Matrix, typed"), lambda _p: Affine("")),
        )

    def stages(self, chain: Sequence[AnyLink]) -> dict[str, list[StageWords]]:
        """As they are drawn."""
        made: dict[str, list[StageWords]] = {}
        for stage in stages(chain):
            told = StageWords(stage.number, stage.symbols.name, in_numbers(stage), caption(stage))
            made.setdefault(stage.link.id, []).append(told)
        return made

    def add(self, thing: str, link: AnyLink) -> Edit:
        """Put a link at the end."""
        return add_transform(thing, link)

    def switch(self, address: str, _link: AnyLink, on: bool) -> Edit:
        """A link on or off."""
        return switch_transform(address, on)

    def remove(self, address: str) -> Edit:
        """Take a link away."""
        return remove_transform(address)

    def reorder(self, address: str, index: int) -> Edit:
        """Let a link act as the one at ``index``."""
        return reorder_transform(address, index)


class ObjectChain:
    """The chain of an object of the scene."""

    none = _("Add an object in Space, or show an example, to transform it.")
    bare = _("This object is as it was made.")

    def offers(self) -> Sequence[Offer]:
        """Every kind, the axes and planes of the frame by their names."""
        return (
            (_("Translation"), lambda _p: Translate3D("", tx=1.0, ty=0.5)),
            (
                _("Rotation about any axis"),
                lambda _p: Rotate3D(
                    "", angle=90.0, x_pivot=1.0, z_pivot=1.0, x_axis=1.0, y_axis=2.0, z_axis=2.0
                ),
            ),
            (_("Rotation about the x axis"), lambda _p: Rotate3D("", angle=45.0, x_axis=1.0, y_axis=0.0)),
            (_("Rotation about the y axis"), lambda _p: Rotate3D("", angle=45.0)),
            (_("Rotation about the z axis"), lambda _p: Rotate3D("", angle=45.0, y_axis=0.0, z_axis=1.0)),
            (_("Scaling"), lambda _p: Scale3D("", sx=1.5, sy=1.5, sz=1.5)),
            (_("Reflection in the xy plane"), lambda _p: Reflect3D("", x_normal=0.0, z_normal=1.0)),
            (_("Reflection in the yz plane"), lambda _p: Reflect3D("")),
            (_("Reflection in the zx plane"), lambda _p: Reflect3D("", x_normal=0.0, y_normal=1.0)),
            (
                _("Reflection in any plane"),
                lambda _p: Reflect3D("", x_pivot=1.0, x_normal=1.0, y_normal=1.0),
            ),
            (_("Shear along x and y by z"), lambda _p: Shear3D("", sh_xz=0.5, sh_yz=0.25)),
            (_("Matrix, typed"), lambda _p: Affine3D("")),
        )

    def stages(self, chain: Sequence[AnyLink3D]) -> dict[str, list[StageWords]]:
        """The seven matrices of each rotation; all others are one."""
        return {link.id: _axis_words(link) for link in chain if link.on and isinstance(link, Rotate3D)}

    def add(self, thing: str, link: AnyLink3D) -> Edit:
        """Put a link at the end."""
        return add_link(thing, link)

    def switch(self, address: str, link: AnyLink3D, on: bool) -> Edit:
        """A link on or off."""
        return set_link(parse(address).figure, replace(link, on=on))

    def remove(self, address: str) -> Edit:
        """Take a link away."""
        return remove_link(parse(address).figure, parse(address).point)

    def reorder(self, address: str, index: int) -> Edit:
        """Let a link act as the one at ``index``."""
        return reorder_link(parse(address).figure, parse(address).point, index)


def _axis_words(link: Rotate3D) -> list[StageWords]:
    words = (
        _("axis to the origin"),
        _("axis into the xz plane"),
        _("axis onto z"),
        _("the turn itself"),
        _("off z again"),
        _("off the xz plane"),
        _("back to its place"),
    )
    return [
        StageWords(number, part.name, "", told)
        for number, (part, told) in enumerate(zip(link.unfolded(), words, strict=True), 1)
    ]
