"""Whether any robot of a package reaches a place, for the values that its arguments have by default or are given."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.xml.parser import Element
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.text import uncommented
from ...package.urdf.expansion.expander import Expander
from ...package.urdf.expansion.expansion import Expansion
from ...package.urdf.expansion.values import Value, XacroUnknown, literal
from ...package.urdf.robot_words import ANY, LAUNCH
from ...source import Span
from ..repository.pages_and_scripts import TEXTS, pages_above
from .enclosing_elements import CONDITIONS, ancestors
from .opened_robots import OpenedRobots
from .reached_files import ROBOTS, ReachedFiles

GIVING = (".py", ".xml", ".launch", ".yaml", ".yml", ".json", ".cpp", ".hpp")
GIVEN = (
    r"[\"']{0}[\"']\s*[,:]\s*(?:default(?:_value)?\s*=\s*)?[\"']([^\"']*)[\"']|\b{0}:=[\"']?([\w.-]+)"
    r"|\bname=\"{0}\"\s+(?:default|value)=\"([^\"]*)\""
)
"""How Python, a command and XML give an argument a literal value, or declare one of its name with it."""
SWITCHED_OFF = "; xacro reaches it only where an argument asks for it"
REPLACED = "; each launch file here gives `{}`, and xacro does not read its default"
FIRST = "; another file gives `{}` its default before xacro reaches this one"
UNREAD = "; xacro fills it in where `{}` is read, which nothing does"


@dataclass(frozen=True)
class WaysIntoRobots:
    reached: ReachedFiles
    opened: OpenedRobots

    def why_unmet(self, path: str, root: Element, place: Span) -> str:
        """Return why xacro does not reach a place of a file, as the end of a sentence; "" where it may."""
        if any(each in self.reached.calls.includes.included_elsewhere for each in (path, *self.opened.including(path))):
            return ""
        around = list(ancestors(root, place))
        for each in around:
            name = each.get("name") or ""
            if each.tag == "xacro:arg" and self.is_given(path, name):
                return REPLACED.format(name)
            if each.tag == "xacro:arg" and self.is_passed_by(path, each):
                return FIRST.format(name)
            if each.tag == "xacro:property" and self.is_unread(each):
                return UNREAD.format(name)
        return self.why_left_out(path, root, place)

    def why_left_out(self, path: str, root: Element, place: Span) -> str:
        """Return that a condition around a place holds for no robot, as the end of a sentence; "" where it may."""
        if any(each in self.reached.calls.includes.included_elsewhere for each in (path, *self.opened.including(path))):
            return ""
        around = list(ancestors(root, place))
        is_known = all(self.is_called_in_sight(each) for each in around if each.tag == "xacro:macro")
        is_off = any(self.is_passed_by(path, each) for each in around if each.tag in CONDITIONS)
        return SWITCHED_OFF if is_known and is_off else ""

    def is_given(self, path: str, argument: str) -> bool:
        """Return whether each launch file gives an argument to a robot, or to what includes it."""
        return any(self.opened.arguments.has(each, argument) for each in (path, *self.opened.including(path)))

    def is_unread(self, element: Element) -> bool:
        is_lazy = element.get("lazy_eval") != "false" and element.get("scope") is None
        return is_lazy and not self.reached.calls.is_read(element)

    def is_passed_by(self, path: str, element: Element) -> bool:
        """Return whether xacro reaches a condition but never enters it, or an argument but never uses its default."""
        found = [each.ways[path, element.span] for each in self.expansions if (path, element.span) in each.ways]
        return bool(found) and not any(found)

    def is_called_in_sight(self, macro: Element) -> bool:
        """Return whether each call of a macro is in a file that a robot reads: else others may give it other values."""
        tag = f"xacro:{(macro.get('name') or '').removeprefix('xacro:')}"
        seen = frozenset[str]().union(*(each.reached for each in self.expansions))
        documents = (each for each in self.reached.library.documents.values() if each is not None)
        calling = {each.source.path for each in documents if any(one.tag == tag for one in each.root.walk())}
        return bool(calling) and calling <= seen

    @cached_property
    def expansions(self) -> tuple[Expansion, ...]:
        """The robots of the package, with the defaults of all arguments but for those that get other values."""
        return tuple(self.expanded())

    def expanded(self) -> Iterator[Expansion]:
        for path in self.reached.files.paths:
            is_robot = path.endswith(ROBOTS) and role_of(path) in ("run", "launch")
            document = self.reached.library.read(path) if is_robot else None
            if document is not None and document.root.tag == "robot" and self.reached.calls.includes.is_top(document):
                expander = Expander(self.reached.library, with_defaults=True)
                expander.texts.defaults.update(self.given(path))
                expander.texts.variables = self.is_set
                yield expander.run(document)

    def given(self, path: str) -> dict[str, Value]:
        """Return the arguments of a robot that get other values than their defaults, with the one that each gets."""
        found: dict[str, Value] = {}
        for name, defaults in self.reached.off.arguments.items():
            values = self.values.get(name)
            if values is not None and len(values) == 1 and self.opened.arguments.has(path, name):
                found[name] = next(iter(values))
            elif values is None or len(values | {literal(each) for each in defaults}) != 1:
                found[name] = XacroUnknown(f"$(arg {name})")
        return found

    def is_set(self, variable: str) -> bool:
        """Return whether a text of the package, or a page or a script above it, names an environment variable."""
        word = re.compile(rf"(?<![\w.-]){re.escape(variable)}(?![\w.-])")
        return any(word.search(text) for _, text in self.givers)

    @cached_property
    def values(self) -> dict[str, set[Value] | None]:
        """By argument, the literal values that anything here gives it; None where it may get any."""
        return {name: self.values_of(name) for name in self.reached.off.arguments}

    def values_of(self, argument: str) -> set[Value] | None:
        """Return the literal values that an argument is given; None where a text names it without a literal value."""
        word = re.compile(rf"(?<![\w.-]){re.escape(argument)}(?![\w.-])")
        ways = re.compile(GIVEN.format(re.escape(argument)))
        own = self.reached.package.name
        others = (facts.robot_words for facts in self.reached.workspace.packages if facts.name != own)
        values: set[Value] = set()
        for each in (each for words in others for each in words):
            if argument in each and (own in each or each >= {LAUNCH, ANY}):
                given = {literal(word.partition(":=")[2]) for word in each if word.startswith(f"{argument}:=")}
                if not given:
                    return None
                values |= given
        for is_page, text in self.givers:
            found = {literal(next(filter(None, each.groups()), "")) for each in ways.finditer(text)}
            if not found and not is_page and word.search(text):
                return None
            values |= found
        return values

    @cached_property
    def givers(self) -> tuple[tuple[bool, str], ...]:
        """The texts that may give an argument a value, each with whether it is a page or a script."""
        files = self.reached.files
        code = [path for path in files.paths if path.endswith(GIVING) and role_of(path) != "test"]
        own = [(False, uncommented(path, files.readable_text(path))) for path in code if path != "package.xml"]
        pages = [(True, files.readable_text(path)) for path in files.paths if path.endswith(TEXTS)]
        return (*own, *pages, *((True, text) for text in pages_above(files)))
