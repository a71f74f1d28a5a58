"""Whatever the table of readable files names is read, by the window's dialog, its drops and the commands."""

from pathlib import Path

import pytest
import trimesh

from workbench.cli.conversions import _read
from workbench.document import save
from workbench.document.samples.examples import example_document
from workbench.exchange.readable import READABLE, SUFFIXES, kind_of
from workbench.exchange.reading import LIMITS
from workbench.widgets.fields.file_dialog import _kinds

CONTENT = {
    "drawing": '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L9 9"/></svg>',
    "points": "0\t1\n2\t9\n4\t1",
}


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_the_table_names_is_read(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"A{suffix.upper()}"
    if kind_of(path) == "mesh":
        made = trimesh.creation.box()
        made.export(path, file_type=suffix[1:])
    elif kind_of(path) == "picture":
        save(example_document(), path)
    else:
        path.write_text(CONTENT[kind_of(path)], encoding="utf-8")
    document, _said = _read(path, 1, None, None)
    (sheet,) = document.sheets
    assert len(sheet.figures) + len(sheet.scene.objects if sheet.scene else ()) == 1
    assert sum(f"*{suffix}" in kind for kind in _kinds()) == 2


def test_every_kind_has_a_limit_and_no_suffix_is_there_twice() -> None:
    assert {each.kind for each in READABLE} <= set(LIMITS)
    assert len(set(SUFFIXES)) == len(SUFFIXES)
    assert kind_of(Path("a.doc")) == kind_of(Path("svg")) == ""
