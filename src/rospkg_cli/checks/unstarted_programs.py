"""Rule input: files of programs that nothing starts or names, while other programs of the package are started."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..package.launch.live_text import live_text
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from .reached_modules import ReachedModules
from .repository.pages_and_scripts import pages_and_scripts
from .share.opened_elsewhere import opening_elsewhere

UNSTARTED = "; nothing here starts this program, as it does others of the package"
STARTING = (".xml", ".launch", ".yaml", ".yml", ".json", ".service", ".desktop", ".conf")
"""Files that start programs, in addition to launch files in Python, pages and scripts."""
STALE = regex(
    r"(?i)\b(?:deprecated|obsolete|legacy|unfinished|wip|work in progress|unused|no longer (?:used|maintained|needed)"
    r"|(?:is |are |currently |still )(?:not|isn't) (?:yet )?(?:finished|complete|working|used|in use|maintained)"
    r"|does(?: not|n't) work|not (?:yet )?(?:been )?(?:fully )?(?:finished|(?:re)?implemented|ported|working))\b"
)
"""How a line of a page says that what it names is out of use or not finished."""
SENTENCES = regex(r"\n|(?<=[.;!?])\s")
LISTED_NAMES = regex(r"(?m)(?:^[ \t]*[-*+][ \t]+`?[\w./-]{1,80}`?[ \t]*\n+)+(?=[a-z])")
"""A list of bare names in the middle of a sentence: `The nodes`, the list, `are not yet finished.`"""
OF_TOOLS = regex(r"(?i)bench(?:mark(?:s|ing)?)?|tools?|experiments?|notebooks?|training|debug(?:ging)?")
BUILDS = ("package.xml", "setup.py", "setup.cfg")


@dataclass(frozen=True)
class UnstartedPrograms:
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    table: InstallTable
    reached: ReachedModules

    def has(self, path: str) -> bool:
        """Return whether no program is started that a Python file is of, and another one is."""
        if not self.table.knows("executable"):
            return False
        own = [name for name, paths in self.of_programs.items() if path in paths]
        return bool(own) and not any(map(self.is_started, own)) and any(map(self.is_started, self.facts.executables))

    def is_beside_started(self, name: str) -> bool:
        """Return whether nothing starts a program, and another one of the package is started."""
        if not self.table.knows("executable") or self.is_clearly_started(name):
            return False
        others = self.facts.executables - {name}
        return any(map(self.is_started, others)) or any(map(self.is_run_elsewhere, others))

    def has_script(self, path: str) -> bool:
        """Return the same of scripts that come with their folder: one that the build names is to be started."""
        own = {name for name, paths in self.of_programs.items() if path in paths} if self.has(path) else set()
        rows = [row for row in self.table.of("executable") if row.destination.rpartition("/")[2] in own]
        return bool(rows) and not any(row.entry or self.is_named_by_build(row.source) for row in rows)

    def is_named_by_build(self, path: str) -> bool:
        word = re.compile(rf"(?<![\w-]){re.escape(path.rpartition('/')[2])}(?![\w-])")
        builds = (
            each for each in self.files.paths if each == "setup.py" or each.endswith(("CMakeLists.txt", ".cmake"))
        )
        return any(word.search(live_text(self.files, each)) for each in builds)

    def is_tool(self, path: str) -> bool:
        """Return whether a file lies in a folder of tools, for benchmarks say, and is a part of no program."""
        folders = path.split("/")[:-1]
        is_in_use = not self.table.knows("executable") or any(path in paths for paths in self.of_programs.values())
        return not is_in_use and any(map(OF_TOOLS.fullmatch, folders))

    @cached_property
    def of_programs(self) -> dict[str, frozenset[str]]:
        """By the name of a program in Python, the files that it is made of."""
        found: dict[str, frozenset[str]] = {}
        for row in self.table.of("executable"):
            name = row.destination.rpartition("/")[2]
            modules = [row.entry.partition(":")[0]] if row.entry else self.imported_by(row.source)
            paths = {
                self.reached.installed.sources.get(each, "") for each in self.reached.imports.imported_from(modules)
            }
            found[name] = found.get(name, frozenset()) | paths | {row.source}
        return found

    def imported_by(self, path: str) -> list[str]:
        file = self.reached.run.modules.at(path) if path.endswith(".py") else None
        imports = file.imports if file is not None else ()
        return [name for each in imports for name in self.reached.imports.imported_by(each, path)]

    def is_started(self, name: str) -> bool:
        """Return whether a launch file of the workspace starts a program, or a text here or above names it."""
        if name not in self.known:
            in_launch = bool(self.workspace.having("started_nodes", self.facts.name, name))
            word = re.compile(rf"(?<![\w-]){re.escape(name.removesuffix('.py'))}(?![\w-])")
            in_text = any(not STALE.search(line) for line in self.lines(word))
            self.known[name] = in_launch or in_text or self.is_run_by_code(name)
        return self.known[name]

    def is_clearly_started(self, name: str) -> bool:
        """Return whether something starts a program, or names it where nothing else has that name.

        A word behind a slash is a topic or a folder, and the name of another package, or of its program, need not
        stand for this program. Nor does a page that only names it where launch files have its start in a comment.
        """
        if not self.is_started(name):
            return self.is_run_elsewhere(name)
        if self.is_run(name) or self.is_run_elsewhere(name):
            return True
        word = re.compile(rf"(?<![\w/-]){re.escape(name)}(?![\w-])|(?<![\w-]){re.escape(name)}\.py\b")
        if self.is_of_others(name) or not any(map(word.search, self.texts)):
            return False
        from .commented_starts import is_start_commented_out  # asked of programs with a fault alone

        return not is_start_commented_out(self.files, self.facts.name, name, self.live_texts)

    def is_of_others(self, name: str) -> bool:
        """Return whether another package of the workspace, or a program of one, has the name of a program."""
        holders = self.workspace.having("executables", name)
        return name in self.workspace.names - {self.facts.name} or any(each.name != self.facts.name for each in holders)

    def is_run_elsewhere(self, name: str) -> bool:
        """Return whether code of another package has a program behind the name of this one."""
        words = self.behind_package(name)
        return any(map(words.search, opening_elsewhere(self.files, self.facts.name, self.workspace)))

    def lines(self, word: re.Pattern[str]) -> Iterator[str]:
        """Yield the lines of texts, or the sentences in them, that have a word."""
        having = (text for text in self.texts if word.search(text))
        return (each for text in having for each in sentences(text) if word.search(each))

    def is_called_stale(self, name: str) -> bool:
        """Return whether a page says of a program that it is no longer used, or not finished yet."""
        word = re.compile(rf"(?<![\w-]){re.escape(name.removesuffix('.py'))}(?![\w-])")
        return any(STALE.search(line) for line in self.lines(word))

    def is_run(self, name: str) -> bool:
        """Return whether a launch file starts a program, or a text or code has it behind the name of its package."""
        if self.workspace.having("started_nodes", self.facts.name, name):
            return True
        words = self.behind_package(name)
        return any(map(words.search, self.texts)) or self.is_run_by_code(name)

    def behind_package(self, name: str) -> re.Pattern[str]:
        own = re.escape(self.facts.name)
        return re.compile(rf"(?<!\w)(?:{own}['\",\s]+|lib/{own}/){re.escape(name)}(?![\w-])")

    @cached_property
    def known(self) -> dict[str, bool]:
        return {}

    @cached_property
    def texts(self) -> tuple[str, ...]:
        return (*pages_and_scripts(self.files), *self.live_texts)

    @cached_property
    def live_texts(self) -> tuple[str, ...]:
        """What the files that start programs say, without comments and unused actions."""
        return tuple(live_text(self.files, path) for path in self.starting())

    def starting(self) -> Iterator[str]:
        for path in self.files.paths:
            if path not in BUILDS and (path.endswith(STARTING) or role_of(path) == "launch"):
                yield path

    def is_run_by_code(self, name: str) -> bool:
        """Return whether code has a program behind the name of its package, as `ros2 run` is given it."""
        words = self.behind_package(name)
        code = (path for path in self.files.paths if path.endswith(".py") and path not in BUILDS)
        return any(words.search(self.files.readable_text(path)) for path in code)


def sentences(text: str) -> list[str]:
    """Return the lines of a page, and the sentences in them; a list of bare names goes with the line that follows."""
    return SENTENCES.split(LISTED_NAMES.sub(lambda found: found[0].replace("\n", " "), text))
