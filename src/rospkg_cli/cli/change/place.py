"""The package that a verb changes, and the run of lint that judges it."""

from __future__ import annotations

from pathlib import Path

from ...change import ChangeError
from ...config.hierarchy import ConfigTree
from ...current_folder import absolute
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.discover import packages_below
from ...engine.discovery.locate import Located, locate
from ...engine.run.session import Session
from ...light_dataclasses import dataclass
from ..lint.lint_options import LintOptions
from ..lint.session import make_session

MAX_NAMED = 5


@dataclass(frozen=True)
class ChangePlace:
    """Where packages are changed: what was located, its configs, and a run of lint with the rules of `rospkg lint`."""

    located: Located
    configs: ConfigTree
    session: Session

    @property
    def root(self) -> Path:
        return self.located.root

    @property
    def folder(self) -> str:
        """The folder of the one package, relative to the root."""
        [only] = self.located.scope.selected
        return only


def place_of(path: Path, *, several: bool = False) -> ChangePlace:
    """Return the place of the package around or at a path, or of all below it; raises ChangeError where none is there.

    A path that does not exist may be the name of a package below the current folder. Raises LocateError, ConfigError
    and UsageError.
    """
    if not path.exists() and len(path.parts) == 1:
        named = [each for each in packages_below(absolute(Path())) if each.name == path.name]
        path = named[0] if len(named) == 1 else path
    configs = choose_configs((path,))
    located = locate((path,), None, configs)
    found = sorted(located.scope.selected)
    if not found:
        why = f": {located.hidden}" if located.hidden else ""
        raise ChangeError(f"there is no package at `{path}`{why}; give the path of one with --package")
    if len(found) > 1 and not several:
        more = ", …" if len(found) > MAX_NAMED else ""
        names = ", ".join(f"`{each}`" for each in found[:MAX_NAMED]) + more
        raise ChangeError(f"`{path}` holds {len(found)} packages ({names}); say which one with --package")
    session = make_session(LintOptions(paths=(path,)), configs, located, lambda _: None)
    return ChangePlace(located, configs, session)
