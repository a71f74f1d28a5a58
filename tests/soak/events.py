"""What a hand does to the window at random: clicks, drags, wheel, keys, numbers, commands, docks, sizes.

Each kind of event takes a ``Hand`` and draws what it does from the hand's own random numbers, so that an
event depends on its seed and number and on what the window then shows, and on nothing before it.
"""

from collections.abc import Callable
from functools import wraps

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QFileDialog,
    QLineEdit,
    QMenu,
    QTabBar,
    QTextBrowser,
)
from shiboken6 import isValid

from tests.soak.hand import CONTROL, PLAIN, Hand, name_of
from workbench.shell.actions import commands, keys_elsewhere

LEFT, RIGHT, MIDDLE = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton
LEFT_OUT = ("quit",)
PAGED = ("space", "display")
HELD = ("Ctrl", "Shift", "Alt")
NUMBERS = (
    *("0", "1", "-1", "2", "3", "7", "12", "30/2", "0.5", "3.75", "-20", "63", "64", "100", "999", "4096"),
    *("5000", "1e9", "-1e9", "1e400", "nan", "", " ", "abc", "1/0", "2^8", "(1", "1,5", "-4", "8 px"),
)
CLIPBOARD = (
    "",
    "1\t2\n3\t4\n9\t2\n12\t30\n",
    "x,y\n1,2\n3,4\n5,nan\n",
    '<svg xmlns="http://www.w3.org/2000/svg"><path d="M1 1 C 9 9 20 2 30 30"/><circle r="4"/></svg>',
    "<svg",
    "no points at all",
)
MORE_KEYS = (
    *("Tab", "Shift+Tab", "Return", "Escape", "Space", "Left", "Right", "Up", "Down", "Home", "End", "Del"),
    *("Shift+Left", "Shift+Up", "Ctrl+A", "Ctrl+C", "Ctrl+V", "Ctrl+X", "Ctrl+Z", "Ctrl+Shift+Z", "Alt+F"),
    *(
        "PgUp",
        "PgDown",
        "Backspace",
        "Ins",
        "1",
        "2",
        "5",
        "0",
        "Menu",
        "Ctrl+Tab",
        "Ctrl+Right",
        "F2",
        "F10",
    ),
)


Event = Callable[[Hand], str]


def in_front(event: Event) -> Event:
    """An event of the main window itself, which a dialog or a menu before it is left for, as it holds it."""

    @wraps(event)
    def done(hand: Hand) -> str:
        before = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        if before is None:
            return event(hand)
        name = name_of(before)
        hand.key("Escape", before)
        return f"not done: left {name}"

    return done


def click(hand: Hand) -> str:
    top = hand.top()
    widget = hand.target(top)
    at = hand.place(top, widget)
    under = hand.under(top, at)
    hand.tell(f"{name_of(under)} in {name_of(under.parentWidget() or top)}")
    button = hand.rng.choice((LEFT, LEFT, LEFT, LEFT, LEFT, RIGHT, MIDDLE))
    modifiers = hand.modifiers()
    double = hand.rng.random() < 0.15
    hand.act(QTest.mouseMove, top, at)
    events = (QTest.mouseDClick,) if double else (QTest.mousePress, QTest.mouseRelease)
    for event in events:
        hand.act(event, top, button, modifiers, at)
    return f"at {at.x()}, {at.y()} {button.name}{' twice' if double else ''}"


def drag(hand: Hand) -> str:
    top = hand.top()
    widget = hand.target(top)
    start = hand.place(top, widget)
    under = hand.under(top, start)
    if isinstance(under, QTabBar):
        return "left to dock_tab"
    if isinstance(top, QFileDialog) or isinstance(under.parentWidget(), QTextBrowser):
        return "not done: Qt would wait for the drop of a file or a text"
    hand.tell(f"{name_of(under)} in {name_of(under.parentWidget() or top)}")
    button = hand.rng.choice((LEFT, LEFT, LEFT, LEFT, MIDDLE))
    modifiers = hand.modifiers()
    hand.act(QTest.mouseMove, top, start)
    hand.act(QTest.mousePress, top, button, modifiers, start)
    at, interrupted = start, ""
    for _move in range(hand.rng.randint(1, 5)):
        at = hand.place(top, widget) if hand.rng.random() < 0.7 else at + QPoint(3, -2)
        hand.act(QTest.mouseMove, top, at)
        if hand.rng.random() < 0.06:
            interrupted = hand.rng.choice(("Escape", "Ctrl+Z", "Del", "Ctrl+Shift+Z", "T", "Ctrl+K"))
            hand.key(interrupted)
    hand.act(QTest.mouseRelease, top, button, modifiers, at)
    return f"{start.x()}, {start.y()} to {at.x()}, {at.y()} {button.name} {interrupted}"


def wheel(hand: Hand) -> str:
    top = hand.top()
    widget = hand.target(top)
    at = hand.place(top, widget)
    under = hand.under(top, at)
    turn = QPoint(0, hand.rng.choice((120, -120, 360, -360, 40)))
    name = name_of(under)
    hand.act(QTest.wheelEvent, top, QPointF(at), turn, QPoint(), hand.modifiers())
    return f"{name} {turn.y()}"


def keys_pressed() -> list[str]:
    """Every key that some part of the program answers, and some that are merely on the keyboard."""
    own = [key for command in commands() if command.id not in LEFT_OUT for key in command.keys]
    own += [key for _part, keys, _text in keys_elsewhere() for key in keys.split(", ")]
    return [*(key for key in own if key not in HELD), *MORE_KEYS]


def key(hand: Hand) -> str:
    chosen = hand.rng.choice(keys_pressed())
    for _again in range(hand.rng.choice((1, 1, 1, 2, 5))):
        hand.key(chosen)
    return chosen


def number(hand: Hand) -> str:
    fields = [f for f in hand.parts() if isinstance(f, QLineEdit) and f.isEnabled()]
    if not fields:
        return "no field"
    field = hand.one_of(fields)
    text = hand.rng.choice(NUMBERS)
    top = field.window()
    at = field.mapTo(top, field.rect().center())
    name = name_of(field)
    hand.act(QTest.mouseClick, top, LEFT, PLAIN, at)
    if isValid(field) and field.hasFocus():
        QTest.keyClick(field, Qt.Key.Key_A, CONTROL)
        QTest.keyClicks(field, text)
        ending = hand.rng.choice(("Return", "Return", "Tab", "Escape", "Up", "Ctrl+Z", ""))
        if ending:
            hand.key(ending)
    return f"{name} {text!r}"


@in_front
def command(hand: Hand) -> str:
    """A command of a menu, or of a panel that is seen."""
    actions = [a for name, a in hand.window.menus.actions.items() if name not in LEFT_OUT]
    for panel in hand.window.panels(hand.window.place):
        actions += panel.actions()
    action: QAction = hand.rng.choice(actions)
    if action.isEnabled():
        action.trigger()
    return action.text()


@in_front
def menu(hand: Hand) -> str:
    """Open a menu of the bar with a click; what pops up is chosen from by later events."""
    bar = hand.window.menu_bar
    titles = [action for action in bar.actions() if action.isVisible()]
    if not bar.isVisible():
        return "not now"
    chosen = hand.rng.choice(titles)
    at = bar.mapTo(hand.window, bar.actionGeometry(chosen).center())
    hand.act(QTest.mouseClick, hand.window, LEFT, PLAIN, at)
    for _step in range(hand.rng.randint(1, 8)):
        if isinstance(QApplication.activePopupWidget(), QMenu):
            hand.key("Down")
    active = QApplication.activePopupWidget()
    entry = active.activeAction() if isinstance(active, QMenu) else None
    if entry is not None and entry.objectName() in LEFT_OUT:
        hand.key("Escape")
    elif active is not None:
        hand.key(hand.rng.choice(("Return", "Return", "Escape")))
    return f"{chosen.text()}: {entry.text() if entry is not None else ''}"


@in_front
def palette(hand: Hand) -> str:
    hand.window.show_palette()
    letters = "".join(hand.rng.choice("abcdefgilmnoprstuvw") for _k in range(hand.rng.randint(1, 3)))
    focus = QApplication.focusWidget()
    if focus is not None:
        QTest.keyClicks(focus, letters if letters != "q" else "")
        for _down in range(hand.rng.randint(0, 3)):
            hand.key("Down")
        hand.key(hand.rng.choice(("Return", "Return", "Escape", "Ctrl+Z", "Tab")))
    return letters


def history(hand: Hand) -> str:
    chosen = hand.rng.choice(("Ctrl+Z", "Ctrl+Z", "Ctrl+Shift+Z"))
    count = hand.rng.randint(1, 6)
    for _again in range(count):
        hand.key(chosen)
    return f"{chosen} {count} times"


@in_front
def workspace(hand: Hand) -> str:
    slug = hand.workspace or hand.rng.choice((*hand.window.workspace_slugs, "home", "settings", "keys"))
    hand.window.go(slug)
    return slug


@in_front
def page(hand: Hand) -> str:
    """Another page of a workspace that has some, by its switch."""
    paged = [each for each in hand.window.workspace_slugs if each in PAGED]
    slug = hand.workspace if hand.workspace in paged else hand.rng.choice(paged)
    if hand.window.place != slug:
        hand.window.go(slug)
    if hand.window.place != slug:
        return f"on the way to {slug}"
    panel = hand.window.panels(slug)[0]
    button = hand.rng.choice(panel.buttons.buttons())
    at = button.mapTo(hand.window, button.rect().center())
    hand.act(QTest.mouseClick, hand.window, LEFT, PLAIN, at)
    return f"{slug} {button.text()}"


@in_front
def example(hand: Hand) -> str:
    from workbench.document.samples.examples import examples  # NumPy comes after what the program sets for it

    slug = hand.rng.choice(examples()).slug
    hand.window.open_example(slug)
    return slug


@in_front
def sheet(hand: Hand) -> str:
    """Another sheet of the picture, or an empty picture."""
    session = hand.window.session
    if hand.rng.random() < 0.3:
        session.new()
        return "new"
    chosen = hand.rng.choice(session.document.sheets)
    hand.window.files.show_sheet(chosen.id)
    return chosen.name


def clipboard(hand: Hand) -> str:
    text = hand.rng.choice(CLIPBOARD)
    QGuiApplication.clipboard().setText(text)
    hand.key("Ctrl+V")
    return repr(text[:12])


@in_front
def dock(hand: Hand) -> str:
    """Float, close or bring back a dock."""
    docks: list[QDockWidget] = hand.window.arrangements.docks(hand.window.place)
    if not docks:
        return "none"
    chosen, act = hand.rng.choice(docks), hand.rng.choice(("float", "close", "show", "raise"))
    if act == "float":
        chosen.setFloating(not chosen.isFloating())
    elif act == "raise":
        chosen.raise_()
    else:
        chosen.setVisible(act == "show")
    return f"{act} {chosen.objectName()}"


@in_front
def dock_tab(hand: Hand) -> str:
    """Drag the tab of a dock along its bar, or out of it."""
    bars = [b for b in hand.parts() if isinstance(b, QTabBar) and b.count() > 1]
    if not bars:
        return "none"
    bar = hand.one_of(bars)
    top, start = bar.window(), bar.tabRect(hand.rng.randrange(bar.count())).center()
    at, name = bar.mapTo(top, start), bar.tabText(bar.tabAt(start))
    hand.act(QTest.mousePress, top, LEFT, PLAIN, at)
    for _move in range(hand.rng.randint(1, 6)):
        sideways = QPoint(hand.rng.randint(-90, 90), hand.rng.choice((0, 0, 0, -60, 60)))
        hand.act(QTest.mouseMove, top, at + sideways)
    hand.act(QTest.mouseRelease, top, LEFT, PLAIN, at + sideways)
    return f"{name} by {sideways.x()}, {sideways.y()}"


@in_front
def resize(hand: Hand) -> str:
    width, height = hand.rng.randint(640, 1400), hand.rng.randint(420, 860)
    if hand.window.isFullScreen():  # nobody can; Qt would call it small while it stays large on the screen
        return "nothing, as it fills the screen"
    hand.window.resize(width, height)
    return f"{width} x {height}"


KINDS: dict[Event, int] = {
    click: 30,
    drag: 22,
    wheel: 4,
    key: 16,
    number: 6,
    command: 6,
    menu: 1,
    palette: 1,
    history: 4,
    workspace: 2,
    page: 2,
    example: 2,
    sheet: 1,
    clipboard: 1,
    dock: 1,
    dock_tab: 1,
    resize: 1,
}
