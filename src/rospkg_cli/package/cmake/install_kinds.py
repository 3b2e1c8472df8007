"""What kind of file a destination below the prefix holds: an executable, a header, a file in share …"""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ..install_table import PYTHON, InstallKind

ALL: tuple[InstallKind, ...] = ("executable", "share", "module", "library", "header", "other")
PLACES: tuple[tuple[str, InstallKind], ...] = (
    ("share/", "share"),
    (PYTHON + "/", "module"),
    ("include/", "header"),
    ("lib/", "library"),
)


@dataclass(frozen=True)
class InstallKinds:
    package: str
    project: str
    """The name that project() sets, which may differ from that of the package."""

    def of(self, destination: str) -> InstallKind:
        if destination.startswith((f"lib/{self.package}/", f"lib/{self.project}/", "bin/")):
            return "executable"
        for prefix, what in PLACES:
            if destination.startswith(prefix):
                return what
        return "other"
