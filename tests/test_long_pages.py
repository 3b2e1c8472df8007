"""Measurements, logs and tables are `.txt` as well: what is longer than people write is no page to read."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.files import MAX_PAGE
from rospkg_cli.testing import lint_files

INSTALLS = CMAKE.replace("ament_package", "install(FILES lab.pgm DESTINATION share/${PROJECT_NAME})\nament_package")


@pytest.mark.parametrize(("length", "level"), [(0, "info"), (MAX_PAGE, "error")])
def test_who_says_that_a_file_is_brought(length: int, level: str) -> None:
    page = "wget https://example.org/lab.pgm\n" + "0.1 0.2\n" * (length // 8)
    files = {**existing_files(BACKDROPS["ament_cmake"]), "CMakeLists.txt": INSTALLS, "data/fetched.txt": page}
    assert [each.severity.value for each in lint_files(files, ["CMK102"]).findings] == [level]
