"""What pip installs together with some libraries, because they require it."""

from __future__ import annotations

from collections.abc import Iterable

from ...ros.read_table import rows, sets

TABLE = "pip_requires.txt"
FRAMEWORKS = frozenset({"torch", "torchvision", "torchaudio", "tensorflow", "keras", "jax", "onnxruntime", "open3d"})
"""Modules of frameworks that people install for the graphics card and the CUDA that they have."""
OTHERWISE = {"whisper": "openai-whisper", "roboticstoolbox": "roboticstoolbox-python"}
"""Modules without a rosdep key whose distribution has another name."""


def required_by(names: Iterable[str]) -> dict[str, str]:
    """Return the distributions that well-known ones require, directly or through others, each with the one of `names`.

    Names are normalised (PEP 503); `names` themselves are left out.
    """
    first, table = sorted(names), rows(TABLE)
    found: dict[str, str] = {}
    for name in first:
        open_ = [name]
        while open_:
            new = [each for each in table.get(open_.pop(), ()) if each not in found and each != name]
            found.update(dict.fromkeys(new, name))
            open_ += new
    return {name: by for name, by in found.items() if name not in set(first)}


def distributions_of(package: str) -> frozenset[str]:
    """Return what PyPI and conda-forge call the module of a ROS package; none where ROS alone has it."""
    return sets(TABLE, "ROS packages").get(package, frozenset())
