"""DEP118: how the YAML of a map names its image, which map_server looks for from the folder of that YAML."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.testing import lint_files

PACKAGE = existing_files(BACKDROPS["ament_python"])
HOME = "/home/ada/ws/src/my_pkg"
MAP = "image: {}\nresolution: 0.05\n"
BESIDE = "; write `office.pgm`: a map's image is looked for next to this file"
MOVED = "; put the image next to this file, and write `office.pgm`: a map's image is looked for there"


def said(image: str, *paths: str, text: str = MAP, at: str = "maps/office.yaml") -> tuple[str, str]:
    files = {**PACKAGE, at: text.format(image), **dict.fromkeys(paths, "P2 1 1 1 0\n")}
    (found,) = lint_files(files, ["DEP118"]).findings
    return found.severity.value, found.message[found.message.index("; ") :]


@pytest.mark.parametrize(
    ("image", "paths", "expected"),
    [
        (f"{HOME}/office.pgm", ["maps/office.pgm"], BESIDE),
        (f"{HOME}/maps/office.pgm", ["maps/office.pgm"], BESIDE),
        (f"{HOME}/maps/office.pgm", [], BESIDE),
        (f"{HOME}/images/office.pgm", ["images/office.pgm"], "; write `../images/office.pgm`: it is looked for from"),
        (f"{HOME}/old/office.pgm", [], MOVED),
    ],
)
def test_an_image_below_the_package(image: str, paths: list[str], expected: str) -> None:
    level, message = said(image, *paths)
    assert (level, message[: len(expected)]) == ("warning", expected)


def test_an_image_elsewhere() -> None:
    assert said("/home/ada/office.pgm", "maps/office.pgm") == ("info", BESIDE)
    assert said("/home/ada/office.pgm") == ("info", MOVED)


def test_other_values_of_that_key_are_no_maps() -> None:
    text = "camera:\n  image: {}\n"
    asked = "; let a parameter or an argument give it"
    assert said("/home/ada/office.pgm", text=text)[1].startswith(asked)
    share = "; have the launch file give it, from the share directory of `my_pkg`"
    assert said(f"{HOME}/old/office.pgm", text=text)[1].startswith(share)
    assert said(f"{HOME}/images/office.pgm", "images/office.pgm", text=text)[1].startswith(share)
