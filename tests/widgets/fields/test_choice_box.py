"""A choice that has no room for its words ends in dots, and is whole where it has."""

from tests.panels.by_hand import keep_until_the_end
from workbench.widgets.fields.choice_box import ChoiceBox

WORDS = "P1  green, 27 ms"


def test_words_without_room_end_in_dots_on_the_box(qtbot):
    box = ChoiceBox(4)
    keep_until_the_end(qtbot, box)
    box.addItem(WORDS)
    box.resize(box.sizeHint())
    box.show()
    qtbot.waitExposed(box)
    cut = box.words_seen()
    assert cut.endswith("…")
    assert WORDS.startswith(cut[:-1])
    other = ChoiceBox(4)
    keep_until_the_end(qtbot, other)
    other.addItem(cut)
    other.resize(box.size())
    other.show()
    qtbot.waitExposed(other)
    assert box.grab().toImage() == other.grab().toImage()
    box.resize(400, box.height())
    assert box.words_seen() == WORDS


def test_what_stands_for_a_choice_is_seen_while_nothing_is_chosen(qtbot):
    box = ChoiceBox(20)
    keep_until_the_end(qtbot, box)
    box.addItem(WORDS)
    box.setPlaceholderText("Ready scenes")
    box.setCurrentIndex(-1)
    box.resize(box.sizeHint())
    box.show()
    qtbot.waitExposed(box)
    told = box.grab().toImage()
    assert box.words_seen() == "Ready scenes"
    box.setPlaceholderText(" ")
    assert box.grab().toImage() != told
    box.setCurrentIndex(0)
    assert box.words_seen() == WORDS
