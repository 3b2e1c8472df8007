"""Which Python libraries a repository has pip install: by its requirements, its Dockerfiles, scripts and pages."""

from __future__ import annotations

import re
from functools import cached_property, lru_cache

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...ros.aliases import key_for_pip
from ...ros.names import Names
from .installing_texts import installing_texts, is_job, names_in, texts_called
from .locked_names import locked_names, may_lock
from .own_requirements import own_requirements
from .pip_requirements import distributions_of, required_by


@dataclass(frozen=True)
class PipInstalls:
    files: PackageFiles

    def has(self, module: str, key: str, index: Names) -> bool:
        """Return whether pip installs the distribution of a module, under its own name or one that rosdep knows."""
        wanted = {normalized(module.partition(".")[0]), *distributions_of(key)}
        return not wanted.isdisjoint(self.names) or any(key_of(name, index) == key for name in self.written)

    def bringer(self, module: str, key: str, index: Names) -> str:
        """Return the library that pip installs and that requires the distribution of a module; "" for none."""
        wanted = normalized(module.partition(".")[0])
        found = (by for name, by in self.required.items() if name == wanted or key_of(name, index) == key)
        return next(found, "")

    @cached_property
    def names(self) -> frozenset[str]:
        """The normalised names of distributions that pip installs."""
        return frozenset(map(normalized, self.written))

    @cached_property
    def required(self) -> dict[str, str]:
        """What these distributions require, each with the one that requires it."""
        return required_by(self.names)

    @cached_property
    def written(self) -> frozenset[str]:
        """The names of distributions, as the files of the package and of the folders above it write them."""
        texts = [*installing_texts(self.files), *texts_called(self.files, is_job)]
        found = {name for path, text in texts for name in names_in(path, text)}
        found.update(own_requirements(self.files, texts))
        listed = (name for path, text in texts_called(self.files, may_lock) for name in locked_names(path, text))
        return frozenset(found.union(listed))


@lru_cache(maxsize=4096)
def key_of(name: str, index: Names) -> str | None:
    """Return the key of rosdep for a name on PyPI; kept, as each missing import asks for all names."""
    return key_for_pip(name, index)


def normalized(name: str) -> str:
    """Return a name as PEP 503 has it."""
    return re.sub(r"[-_.]+", "-", name).lower()
