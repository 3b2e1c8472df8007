"""The data beside the code is found."""

from __future__ import annotations

from pathlib import Path

import pytest

from rospkg_cli import resources


def test_a_checkout_has_them_at_the_top() -> None:
    assert (resources.resources("schemas") / "package_format3.xsd").is_file()
    assert resources.resources("templates").is_dir()


def test_a_wheel_has_them_in_the_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "_schemas").mkdir()
    monkeypatch.setattr(resources, "HERE", tmp_path)
    assert resources.resources("schemas") == tmp_path / "_schemas"
