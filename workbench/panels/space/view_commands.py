"""The commands by which a scene is looked at: another projection, another side, back to its own camera."""

from msgspec.structs import replace

from workbench.document.scene.model import Camera, Scene
from workbench.language import _
from workbench.panels.space.eye_view import EyeView
from workbench.panels.space.looking import Looking
from workbench.panels.space.morph import Morph
from workbench.panels.space.outside_view import OutsideView


class ViewCommands:
    """What a page with a picture and an outside view does with its camera; all of the scene is seen then.

    ``_kept`` is the scene that the picture was last fitted to; with None it is fitted anew.
    """

    looking: Looking
    eye: EyeView
    outside: OutsideView
    morph: Morph
    _kept: Scene | None

    def say(self, sentence: str) -> None:
        """Say something in the status bar."""
        raise NotImplementedError

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened."""
        raise NotImplementedError

    def choose(self, slug: str) -> None:
        """Give the scene another projection."""
        self.morph.leave(self.looking.camera)
        self.say(self.looking.choose(slug, _("Change the projection")))
        self.eye.keeps_fit = True

    def face(self, side: str) -> None:
        """Stand before one of the six sides, and see all of the scene."""
        self.say(self.looking.face(side))
        self.eye.keeps_fit = True
        self._kept = None

    def glance(self, slug: str) -> None:
        """See the scene by another projection from where that is at its best; the document keeps its own."""
        self.morph.leave(self.looking.camera)
        self.say(self.looking.glance(slug))
        self.eye.keeps_fit = True
        self._kept = None

    def keep(self) -> None:
        """Write what is seen now into the document."""
        self.say(self.looking.keep())

    def switch(self) -> None:
        """Exchange perspective and parallel projection, from the same place."""
        camera = self.looking.camera
        other = "orthographic" if camera.projection == "perspective" else "perspective"
        self.look(replace(camera, projection=other))

    def look(self, camera: Camera) -> None:
        """See all of the scene by another camera; the document keeps its own."""
        self.say(self.looking.look(camera))
        self.eye.keeps_fit = True
        self._kept = None

    def go_to(self, camera: Camera) -> None:
        """See the scene by another camera, by way of what lies between; the document keeps its own."""
        self.morph.leave(self.looking.camera)
        self.look(camera)

    def go_home(self) -> None:
        """See the scene as the document has it, and all of it."""
        self.say(self.looking.look(None))
        self.eye.keeps_fit = True
        self.outside.stand_aside()
        self._kept = None
        self.refresh_soon()

    def _arrive(self) -> None:
        """The new projection itself is seen."""
        self._kept = None
        self.refresh_soon()
