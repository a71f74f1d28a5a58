"""Colours Python source by the tokens of the theme."""

from collections.abc import Sequence

from pygments.lexers.python import PythonLexer
from pygments.token import Comment, Keyword, Name, Number, Operator, String, Token
from PySide6.QtGui import QFont, QSyntaxHighlighter, QTextCharFormat, QTextDocument

from workbench.widgets.look.tokens import Tokens, colour, theme, tokens


class SourceHighlighter(QSyntaxHighlighter):
    """Highlights a document that holds one function; lexed once, coloured line by line.

    ``rows`` tells which line of what was lexed each line of the document is.
    """

    def __init__(self, document: QTextDocument) -> None:
        super().__init__(document)
        self.rows: Sequence[int] = ()
        self._lines: list[list[tuple[int, int, object]]] = []
        self._formats: dict[object, QTextCharFormat] = {}
        self._take_theme()
        theme.changed.connect(self._take_theme)

    def lex(self, source: str) -> None:
        """Learn the text that the document is about to hold."""
        self._lines = [[]]
        column = 0
        for kind, text in PythonLexer(stripnl=False).get_tokens(source):
            for number, piece in enumerate(text.split("\n")):
                if number:
                    self._lines.append([])
                    column = 0
                if piece:
                    self._lines[-1].append((column, len(piece), kind))
                    column += len(piece)

    def _take_theme(self) -> None:
        self._formats = _formats(tokens())
        self.rehighlight()

    def highlightBlock(self, text: str) -> None:
        """Called by Qt for each line."""
        number = self.currentBlock().blockNumber()
        if number >= len(self.rows) or self.rows[number] >= len(self._lines):
            return
        for start, length, kind in self._lines[self.rows[number]]:
            while kind is not None and kind is not Token and kind not in self._formats:
                kind = kind.parent  # type: ignore[attr-defined]
            if kind in self._formats:
                self.setFormat(start, length, self._formats[kind])


def _formats(now: Tokens) -> dict[object, QTextCharFormat]:
    def made(ink: str, bold: bool = False, italic: bool = False) -> QTextCharFormat:
        style = QTextCharFormat()
        style.setForeground(colour(ink))
        style.setFontWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
        style.setFontItalic(italic)
        return style

    return {
        Comment: made(now.data[2], bold=True),
        Keyword: made(now.accent),
        Keyword.Constant: made(now.data[3]),
        Name.Function: made(now.text, bold=True),
        Name.Builtin: made(now.text),
        Number: made(now.data[3]),
        Operator: made(now.text),
        Operator.Word: made(now.accent),
        String: made(now.data[4]),
        String.Doc: made(now.muted, italic=True),
    }
