"""Fixtures that every test may use."""

from __future__ import annotations

import os
import signal
from collections.abc import Mapping
from pathlib import Path

import pytest
from hypothesis import settings
from writing import Write

from rospkg_cli.example import Example
from rospkg_cli.tree import to_entry

settings.register_profile("usual", deadline=None)
settings.register_profile("ci", deadline=None, derandomize=True)
settings.register_profile("quick", deadline=None, max_examples=15)
settings.load_profile(os.environ.get("ROSPKG_HYPOTHESIS") or ("ci" if os.environ.get("CI") == "true" else "usual"))


@pytest.fixture
def write() -> Write:
    """Return a function that writes a tree of texts below a folder; a text that begins with `#!` is executable."""

    def write_tree(folder: Path, files: Mapping[str, str]) -> Path:
        for path, text in files.items():
            target = folder / path
            target.parent.mkdir(parents=True, exist_ok=True)
            entry = to_entry(text)
            target.write_bytes(entry.data)
            target.chmod(entry.mode)
        return folder

    return write_tree


@pytest.fixture
def clean() -> dict[str, str]:
    """Return the files of a faultless ament_python package called my_pkg."""
    return Example(bad={}, good={}).bad_files()


@pytest.fixture(autouse=True)
def no_surroundings(monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep the ROS of the machine, its colours, and the user's cache and index out of the tests."""
    for name in ("ROS_DISTRO", "AMENT_PREFIX_PATH", "NO_COLOR", "FORCE_COLOR", "CI", "GITHUB_ACTIONS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", os.devnull)


def pytest_configure() -> None:
    """Let Ctrl-C reach the processes of the tests, also where pytest itself runs in the background."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-golden", action="store_true", help="write golden files anew (findings, fixes, trees, corpus)"
    )


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let the real builds begin first: at the end, the last of them would keep one worker while the other idles."""
    items.sort(key=lambda item: "real" not in item.path.parts)
