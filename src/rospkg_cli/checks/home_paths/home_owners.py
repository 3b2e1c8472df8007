"""Whose home folders paths are in: accounts that many people have, and homes that everybody replaces by their own."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ..repository.home_accounts import is_of_container, is_of_many


@dataclass(frozen=True)
class HomeOwners:
    files: PackageFiles

    def are_many(self, user: str) -> bool:
        """Return whether many people, or a container of the repository, have an account of that name."""
        if user not in self._accounts:
            self._accounts[user] = is_of_many(user) or is_of_container(self.files, user)
        return self._accounts[user]

    def is_home_replaced(self, user: str) -> bool:
        """Return whether a page or a script has everybody write their own home, or mounts this one."""
        if user not in self._replaced:
            from ..repository.replaced_homes import is_home_replaced  # few files have such a path

            self._replaced[user] = is_home_replaced(self.files, user)
        return self._replaced[user]

    @cached_property
    def _accounts(self) -> dict[str, bool]:
        """The answers of `are_many`, by account."""
        return {}

    @cached_property
    def _replaced(self) -> dict[str, bool]:
        """The answers of `is_home_replaced`, by account."""
        return {}
