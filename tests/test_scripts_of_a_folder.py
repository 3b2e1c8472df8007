"""A script that only came with its folder, without a bit or a `#!`, is no program that anybody starts."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

INSTALLS = "install(DIRECTORY nodes DESTINATION lib/${PROJECT_NAME} USE_SOURCE_PERMISSIONS)\nament_package"
FILES = {
    **existing_files(BACKDROPS["ament_cmake"]),
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS),
}
LINE = "print(tulips)\n"


@pytest.mark.parametrize("path", ["nodes/try.py", "nodes/test_2.py"])
@pytest.mark.parametrize(
    ("text", "more", "level"),
    [
        (LINE, {}, "info"),
        (f"#!/usr/bin/env python3\n{LINE}", {}, "error"),
        (LINE, {"README.md": "    cd nodes; python3 try.py; python3 test_2.py\n"}, "error"),
    ],
)
def test_who_starts_a_script_of_a_folder(path: str, text: str, more: dict[str, str], level: str) -> None:
    (found,) = lint_files({**FILES, path: text, **more}, ["DEP117"]).findings
    assert found.severity.value == level
