"""Rule input: whether other packages of the workspace name a robot's file, by the words of their launch files."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import may_be_made
from ...package.workspace import Workspace


@dataclass(frozen=True)
class NamingPackages:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, path: str) -> bool:
        """Return whether a text of another package names a file.

        The text names this package too, or no other package that has a file of this name.
        """
        name, own = path.rpartition("/")[2], self.package.name
        stem = name.partition(".")[0]
        if self.workspace.named(stem) is not None:
            stem = name  # the word alone is a package
        for facts in self.workspace.packages:
            for words in facts.robot_words if facts.name != own else ():
                is_stem = stem in words and not self.is_of_other_suffix(words, name)
                if own in words and (is_stem or may_be_made(name, words)):
                    return True
                if is_stem and not any(other in words for other in self.having(name)):
                    return True
        return False

    def is_of_other_suffix(self, words: frozenset[str], name: str) -> bool:
        """Return whether words name another file of the same stem (`arm.sdf` for `arm.urdf`), and not this one."""
        stem = name.partition(".")[0]
        others = {each.rpartition("/")[2] for each in self.files.paths} - {name}
        return name not in words and any(each in words for each in others if each.partition(".")[0] == stem)

    def having(self, name: str) -> list[str]:
        """Return the other packages that have a file of a name."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        return [
            each.name
            for each in others
            if any(p.rpartition("/")[2] == name for p in (*each.share_files, *each.uninstalled))
        ]
