"""Who installs a Python module: its ROS package, or its rosdep key."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from functools import lru_cache

from ..light_dataclasses import dataclass
from .names import BUILT_IN, Names
from .read_table import rows, words

STANDARD = frozenset(sys.stdlib_module_names) | words("standard_modules.txt")
"""Modules of the standard library of any Python that a supported distribution comes with."""

NO_PYTHON = "?"

HOSTS = frozenset(
    "bpy c4d carb isaacgym isaaclab isaaclab_assets isaaclab_tasks isaacsim micropython omni rhinoscriptsyntax unreal "
    "uasyncio umachine utime".split()
)
"""Modules that only a program with a Python of its own brings, or a microcontroller."""

OF_HOSTS = {
    "controller": frozenset({"Robot", "Supervisor"}),
    "machine": frozenset({"ADC", "I2C", "PWM", "Pin", "SPI", "Timer", "UART"}),
    "maya": frozenset({"OpenMaya", "OpenMayaUI", "cmds", "mel"}),
}
"""Such modules with names that others may have as well, by what is taken from them: of Webots, MicroPython, Maya."""

NO_MODULES = frozenset({"git", "msgpack", "vlc", "yaml"})
"""Keys of rosdep that install a program or a library for C, and no module of their name."""


@dataclass(frozen=True, slots=True)
class Providers:
    """The dependencies that install an imported module: any of them is enough, the first is the preferred one."""

    names: tuple[str, ...] = ()

    @property
    def preferred(self) -> str:
        return self.names[0]


def providers(module: str, names: Names = BUILT_IN) -> Providers:
    """Return the dependencies that install a dotted module; none for a standard or an unknown module.

    Where a package and a key of Python have the name, the package is the C++ library: the key comes first.
    """
    table = rows("imports.txt")
    for prefix in prefixes(module):
        if prefix in table:
            found = tuple(name for name in table[prefix] if name != NO_PYTHON)
            return Providers(found)
    top = module.partition(".")[0]
    if top in STANDARD:
        return Providers()
    keys = tuple(key for key in keys_called_like(top) if names.is_key(key))
    return Providers((*keys, top) if names.is_package(top) else keys)


def prefixes(module: str) -> Iterator[str]:
    """Yield a dotted name and the packages around it, the longest first."""
    while module:
        yield module
        module = module.rpartition(".")[0]


def keys_called_like(module: str) -> tuple[str, str]:
    """Return the keys that Debian's Python policy and rosdep's naming rule give a module."""
    key = "python3-" + module.lower().replace("_", "-")
    return key, key + "-pip"


def may_serve(dependency: str, module: str) -> bool:
    """Return whether a declared name may be another dependency that installs a module, so that none is missing."""
    return served_module(dependency) == module.partition(".")[0].lower()


@lru_cache(maxsize=4096)
def served_module(dependency: str) -> str | None:
    """Return the module that a dependency may install by its name, in lower case; None where it installs none."""
    if dependency in NO_MODULES:
        return None
    bare = dependency.lower().removeprefix("python3-").removeprefix("python-").removesuffix("-pip")
    return bare.replace("-", "_").replace(".", "_")
