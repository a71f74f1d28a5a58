"""What an algorithm says of itself: its arguments, its laws, its source, and what comes after it."""

from collections.abc import Callable, Iterable
from html import escape

from PySide6.QtCore import QUrl, Signal
from PySide6.QtWidgets import QTextBrowser, QVBoxLayout, QWidget

from workbench.algorithms import catalogue
from workbench.algorithms.entry import DrawnBy, Entry, Parameter
from workbench.engine.sentences import number_text
from workbench.language import _, ngettext
from workbench.session.run import Run
from workbench.widgets.fields.number_field import with_subscript
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tokens import TITLE_PX, theme, tokens
from workbench.widgets.look.type_faces import scaled, type_scale


class AboutView(QWidget):
    """Tells of the algorithm of ``run``; the text can be copied.

    ``rung_wanted``: the slug of the next rung was chosen; it is a link where ``possible`` says that it can be
    chosen now.
    """

    rung_wanted = Signal(str)
    example_wanted = Signal()

    def __init__(self, run: Run, possible: Callable[[str], bool], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run, self._possible = run, possible
        self._told: tuple[str, bool] | None = None
        self.text = QTextBrowser()
        self.text.setOpenLinks(False)
        self.text.setAccessibleName(_("About this algorithm"))
        self.text.document().setDocumentMargin(12)
        self.text.anchorClicked.connect(self._follow)
        self.state = EmptyView(self.text, _("Draw a figure to read about its algorithm here."))
        self.state.wanted.connect(self.example_wanted)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.state)
        self.setFocusProxy(self.text)
        self._sight = InSight(self)
        self._sight.changed.connect(self.refresh)
        run.changed.connect(self.refresh)
        theme.changed.connect(self._tell_again)
        type_scale.changed.connect(self._tell_again)
        self.refresh()

    def refresh(self, *_seen: bool) -> None:
        """Tell of the run's algorithm, where it is another one."""
        entry = self._run.entry
        self.state.set_empty(entry is None)
        if entry is None or not self._sight.now:  # behind other tabs nothing is written
            return
        told = entry.slug, bool(entry.next_rung) and self._possible(entry.next_rung)
        if told != self._told:
            same = self._told is not None and self._told[0] == entry.slug
            bar = self.text.verticalScrollBar()
            place = bar.value() if same else 0
            self._told = told
            self.text.setHtml(page_of(entry, told[1]))
            bar.setValue(place)

    def _tell_again(self) -> None:
        self._told = None
        self.refresh()

    def _follow(self, link: QUrl) -> None:
        self.rung_wanted.emit(link.path())


def page_of(entry: Entry, linked: bool) -> str:
    """The page of an entry, as rich text; ``linked`` makes a link of its next rung."""
    parts = [
        f'<p style="font-size:{scaled(TITLE_PX)}px; font-weight:600; margin:0">{escape(_(entry.title))}</p>',
        f'<p style="margin:4px 0 0 0">{escape(_(entry.summary))}</p>',
    ]
    if entry.next_rung:
        parts.append(_next_rung(catalogue.get(entry.next_rung), linked))
    if entry.drawn_by is not None:
        parts.append(_section(_("In pictures"), _paragraph(_stand_in(entry.drawn_by))))
    if entry.works_in:
        parts.append(_section(_("Works in"), _paragraph(_(entry.works_in))))
    if entry.laws:
        parts.append(_section(_("Always true"), _list(_(law.sentence) for law in entry.laws)))
    if entry.not_laws:
        title = _("Not true, though you might think so")
        parts.append(_section(title, _list(_(sentence) for sentence in entry.not_laws)))
    if entry.tie:
        parts.append(_section(_("Exactly halfway"), _paragraph(_(entry.tie))))
    parts.append(_section(_("Takes"), _arguments(entry.parameters)))
    parts.append(_section(_("Gives"), _paragraph(_given(entry))))
    parts.append(_section(_("Source"), _paragraph(_(entry.source))))
    if entry.questions:
        numbers = ", ".join(str(number) for number in entry.questions)
        text = ngettext("Question {numbers} on Home", "Questions {numbers} on Home", len(entry.questions))
        parts.append(_section(_("Serves"), _paragraph(text.format(numbers=numbers))))
    if entry.labs:
        parts.append(_section(_("Labs"), _list(_(lab) for lab in entry.labs)))
    if entry.compiles:
        parts.append(_section(_("Stepped only"), _paragraph(_(entry.compiles))))
    return "".join(parts)


def _section(title: str, body: str) -> str:
    return (
        f'<p style="color:{tokens().muted}; font-weight:600; margin:12px 0 2px 0">{escape(title)}</p>{body}'
    )


def _paragraph(text: str) -> str:
    return f'<p style="margin:0">{escape(text)}</p>'


def _list(sentences: Iterable[str]) -> str:
    items = "".join(f'<li style="margin:0 0 3px 0">{escape(sentence)}</li>' for sentence in sentences)
    return f'<ul style="margin:0; -qt-list-indent:0; margin-left:14px">{items}</ul>'


def _next_rung(entry: Entry, linked: bool) -> str:
    title = escape(_(entry.title))
    if linked:
        title = f'<a href="{entry.slug}" style="color:{tokens().accent}">{title}</a>'
    label = escape(_("Next on the ladder:"))
    return f'<p style="margin:8px 0 0 0"><span style="color:{tokens().muted}">{label}</span> {title}</p>'


def _stand_in(by: DrawnBy) -> str:
    """Which entry paints for this one, and where."""
    title, law = _(catalogue.get(by.slug).title), _(by.law.sentence)
    text = _(
        "Pictures are drawn by “{title}”, which is faster, wherever this law holds: {law} Steps, tables and "
        "counts are always this algorithm's own."
    )
    return text.format(title=title, law=law)


def _arguments(parameters: tuple[Parameter, ...]) -> str:
    rows = []
    for parameter in parameters:
        name = with_subscript(parameter.label.replace("{", "").replace("}", ""))
        meaning = f'{escape(_(parameter.meaning))}<br><span style="color:{tokens().muted}">'
        rows.append(
            f'<tr><td style="padding-right:12px">{name}</td>'
            f"<td>{meaning}{escape(_range_of(parameter))}</span></td></tr>"
        )
    return f'<table cellspacing="0" cellpadding="1">{"".join(rows)}</table>'


def _range_of(parameter: Parameter) -> str:
    """What values a parameter may have, with its unit."""
    kinds = {
        "int": _("whole number"),
        "float": _("number"),
        "bool": _("yes or no"),
        "colour": _("colour"),
        "image": _("picture"),
        "depth": _("a depth for each pixel"),
        "points": _("list of points"),
        "floats": _("list of numbers"),
        "ints": _("list of whole numbers"),
        "matrix": _("matrix"),
    }
    kind = kinds[parameter.kind]
    low, high = parameter.low, parameter.high
    if parameter.kind in ("int", "float") and low is not None and high is not None:
        kind = _("{kind}, {low} to {high}").format(kind=kind, low=number_text(low), high=number_text(high))
    elif parameter.kind in ("int", "float") and low is not None:
        kind = _("{kind}, at least {low}").format(kind=kind, low=number_text(low))
    return f"{kind} {parameter.unit}" if parameter.unit else kind


def _given(entry: Entry) -> str:
    """What an algorithm makes."""
    return {
        "pixels": _("Pixels, one after the other."),
        "coverage": _("Pixels, each with the part of it that is lit."),
        "spans": _("Spans: a row, and its first and last pixel."),
        "fragments": _("Fragments: a pixel, its depth, and whether it won."),
        "points": _("Points."),
        "segments": _("Line segments."),
        "cells": _("Cells of a matrix: row and column, counted from 0, and the number in it."),
        "cubes": _("Cubes: the lowest corner, the side, and 0 for empty, 1 for full, 2 for partial."),
    }[entry.emits]
