"""setup.cfg with the folder of executables, in a package that had none so far."""

from __future__ import annotations

from collections.abc import Iterator

from ..change import NotUnderstoodError, Paste
from ..edits.setup_cfg import new_setup_cfg, put_option
from ..light_dataclasses import dataclass
from ..package.install_table import InstallTable
from ..package.package import Package
from ..package.setup.setup_cfg import SetupCfg
from .dependency import manifest_of
from .entry_point import setup_of
from .part import Operations

OPTIONS = (("develop", "script_dir"), ("install", "install_scripts"))
"""Sections of setup.cfg, and the option of each that says where executables go."""


@dataclass(frozen=True)
class ScriptsFolder:
    """What sends an executable to lib/<package>, where `ros2 run` looks."""

    executable: str

    def add(self, package: Package) -> Operations:
        """Return setup.cfg or its options; nothing where the executable goes there already.

        Raises NotUnderstoodError where other executables would move with it.
        """
        name, setup = manifest_of(package).name, setup_of(package)
        table = package.parts(InstallTable).only
        places = {row.destination for row in table.rows if row.what == "executable"} if table else set()
        if f"lib/{name}/{self.executable}" in places or not any(self.is_place(each) for each in places):
            return ()
        created = new_setup_cfg(name)
        if any(each.is_script and each.name != self.executable for each in setup.entry_points):
            raise NotUnderstoodError(
                "the executables of this package go to bin/, where `ros2 run` does not look: where all of them are "
                "nodes, write the lines, and run the command again",
                Paste("setup.cfg", created.text.rstrip()),
            )
        cfg = package.parts(SetupCfg).only
        if cfg is None:
            return () if package.files.is_there("setup.cfg") else (created,)
        missing = [(section, key) for section, key in OPTIONS if cfg.get(section, key) is None]
        return put_option(cfg, missing, f"$base/lib/{name}")

    def is_place(self, destination: str) -> bool:
        return destination.rpartition("/")[2] == self.executable

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield nothing: setup.cfg also serves later executables, and it is not known for which it was added."""
        yield from ()
