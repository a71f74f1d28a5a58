"""The card of Animate: the numbers of what is selected in the frame that is shown, without algorithms."""

from workbench.panels.stage.card import ParameterCard


class AnimateCard(ParameterCard):
    """As everywhere; what a figure is drawn by is no matter here."""

    offers_algorithms = False

    def fold(self) -> None:
        """Leave the room to the picture; motion goes over all of it."""
        self._set_open(False)
