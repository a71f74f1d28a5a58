"""GIFs, numbered pictures and contact sheets of a sheet that moves, read back by Pillow."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.document.motion.moving import still, track, with_tracks
from workbench.cli.commands import main
from workbench.document import save
from workbench.document.motion.evaluation import at
from workbench.exchange.frames import delays_ms
from workbench.exchange.moving_sheets import MovingSheet, Size
from workbench.exchange.writing import write
from workbench.exchange.written import formats
from workbench.geometry.conventions import top_row_first
from workbench.rendering import frame_buffer

MOVING = with_tracks(still(), track("f1/radius_world", (0, (2.0,)), (11, (13.0,))), frames=12)


def rgb(frame: int) -> np.ndarray:
    packed = top_row_first(frame_buffer(at(MOVING.sheets[0], frame)))
    return np.stack([packed >> 16 & 255, packed >> 8 & 255, packed & 255], axis=-1)


def test_a_gif_has_the_pictures_and_the_time_of_all_frames(tmp_path: Path) -> None:
    (path,) = write(formats("animation")[0], MovingSheet(MOVING.sheets[0]), tmp_path / "a.gif")
    with Image.open(path) as gif:
        assert gif.n_frames == 12
        durations = []
        for frame in range(12):
            gif.seek(frame)
            durations.append(gif.info["duration"])
            assert np.array_equal(np.asarray(gif.convert("RGB")), rgb(frame))
    assert sum(durations) == 500
    assert set(durations) == {40, 50}


@pytest.mark.parametrize(
    ("rate", "shown"),
    [(0.0, list(range(12))), (12.0, [0, 2, 4, 6, 8, 10]), (48.0, [n // 2 for n in range(24)])],
)
def test_another_rate_shows_other_frames_in_the_same_time(rate: float, shown: list[int]) -> None:
    frames = MovingSheet(MOVING.sheets[0], rate=rate)
    assert [frames.frame(number) for number in range(frames.parts)] == shown
    assert sum(delays_ms(frames)) == pytest.approx(500, abs=30)


def test_pixels_stay_whole_at_another_size() -> None:
    frames = MovingSheet(MOVING.sheets[0], Size(80, 60))
    assert np.array_equal(frames.image(5), np.repeat(np.repeat(rgb(5), 2, axis=0), 2, axis=1))


@pytest.mark.parametrize(("size", "left", "top"), [(Size(80, 90), 0, 15), (Size(100, 60), 10, 0)])
def test_in_another_shape_it_keeps_its_own_in_the_middle(size: Size, left: int, top: int) -> None:
    sheet = MOVING.sheets[0]
    image = MovingSheet(sheet, size).image(5)
    inside = (slice(top, top + 60), slice(left, left + 80))
    assert np.array_equal(image[inside], np.repeat(np.repeat(rgb(5), 2, axis=0), 2, axis=1))
    ground = sheet.palette[sheet.background]
    image[inside] = [ground >> 16, ground >> 8 & 255, ground & 255]
    assert (image == image[0, 0]).all()
    assert image.shape == (size.height, size.width, 3)


@pytest.mark.parametrize(
    ("size", "rate"), [(Size(0, 3), 0.0), (Size(3, 5000), 0.0), (None, 1e4), (None, -1.0)]
)
def test_what_cannot_be_made_is_said(size: Size | None, rate: float) -> None:
    with pytest.raises(ValueError, match=r"cannot be (made|written)"):
        MovingSheet(MOVING.sheets[0], size, rate)


def test_the_command_line_writes_all_three(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    save(MOVING, tmp_path / "a.gwb")
    save(still(), tmp_path / "still.gwb")
    source = str(tmp_path / "a.gwb")
    assert main(["animate", source, "-o", str(tmp_path / "a.gif"), "--size", "20x15", "--rate", "6"]) == 0
    with Image.open(tmp_path / "a.gif") as gif:
        assert (gif.n_frames, gif.size) == (3, (20, 15))
    assert main(["animate", source, "-o", str(tmp_path / "f.png")]) == 0
    assert len(list(tmp_path.glob("f-*.png"))) == 12
    assert main(["animate", source, "-o", str(tmp_path / "all.png"), "--contacts"]) == 0
    with Image.open(tmp_path / "all.png") as whole:
        assert whole.size == (4 * 44, 3 * 34)
    for wrong in (
        [source, "-o", str(tmp_path / "a.avi")],
        [source, "-o", str(tmp_path / "a.gif"), "--rate", "0"],
        [str(tmp_path / "still.gwb"), "-o", str(tmp_path / "b.gif")],
    ):
        assert main(["animate", *wrong]) == 2
    assert "nothing moves" in capsys.readouterr().err
