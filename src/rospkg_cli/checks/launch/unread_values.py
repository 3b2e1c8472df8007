"""What a launch file sets and nothing reads: the defaults of arguments, `<let>`, what included files do not take, and
the variables that lead there.
"""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...languages.python.unread_values import only_read_in
from ...light_dataclasses import dataclass
from ...package.launch.file_references import FileReference, first_in
from ...package.launch.launched_parts import DeclaredArgument, Include
from ...package.launch.live_text import without, without_unread
from ...package.launch.text import uncommented
from ...ros.known_launch_files import known_arguments
from ...source import Span
from .include_arguments import IncludeContext
from .launch_configurations import OWN, LaunchConfigurations
from .launch_context import LaunchContext
from .missing_reference import MissingReference, defaults_of, is_within

Names = frozenset[str]
ANY = "launch_configurations"
"""What asks for arguments of any name: Python for all at once."""
SUBSTITUTED, YAML = "allow_substs", (".yaml", ".yml")
"""Files of parameters with substitutions ask for arguments: `$(var map)`."""


@dataclass(frozen=True)
class UnreadValues:
    scope: LaunchContext

    def has(self, missing: MissingReference) -> bool:
        """Return whether every place that names a file is one that nothing reads."""
        places = (missing.span, *missing.other_spans)
        alone = missing.use == "file" and all(any(d.contains(each) for d in self.set_in_vain) for each in places)
        return alone or is_within(missing, tuple(defaults_of(self.arguments)))

    def holds(self, place: Span) -> bool:
        """Return whether the text at a place is passed only to what nothing reads."""
        return any(each.contains(place) for each in self.places)

    @cached_property
    def places(self) -> tuple[Span, ...]:
        """Where the values stand themselves, and what is put into variables that only they read."""
        untaken = IncludeContext(self.scope).untaken()
        own = [*(each.span for each in self.arguments), *self.set_in_vain, *untaken]
        python = self.scope.file.python
        if python is None:  # what Python has as a default may be written elsewhere, and be read there, too
            return (*own, *(each.default.span for each in self.arguments if each.default is not None))
        return (*own, *(only_read_in(python, own) if own else ()))

    @property
    def read_text(self) -> str:
        """The text of the file without comments, and without what nothing reads; one for ROS 1 says nothing."""
        file = self.scope.file
        if file.is_ros1:
            return ""
        python, text = file.python, file.source.text
        return uncommented(file.path, without_unread(python, self.places) if python else without(text, self.places))

    @cached_property
    def arguments(self) -> tuple[DeclaredArgument, ...]:
        """The arguments that neither the file nor what it includes reads."""
        names = ((each, each.name.literal or "") for each in self.scope.file.arguments)
        return tuple(each for each, name in names if name and self.is_idle(name, each.span))

    @cached_property
    def set_in_vain(self) -> tuple[Span, ...]:
        """The values of `<let>` that nothing reads."""
        root = self.scope.file.root
        lets = [each for each in root.walk() if each.name == "let"] if root is not None else []
        named = ((each.attributes.get("name"), each.attributes.get("value"), each.span) for each in lets)
        return tuple(v.span for n, v, span in named if n is not None and v is not None and self.is_idle(n.text, span))

    @cached_property
    def configurations(self) -> LaunchConfigurations:
        return LaunchConfigurations(self.scope.workspace, self.scope.file)

    def is_idle(self, name: str, declared: Span) -> bool:
        """Return whether nothing of the file, of those that it includes, or that include it, reads a configuration."""
        file = self.scope.file
        if file.is_ros1 or name in OWN or not file.has_entry_point or self.may_read_any or name in self.read:
            return False
        if self.configurations.has_other_mention(name, declared, in_comments=False) or self.may_be_substituted(name):
            return False
        return not any(self.is_taken(each, name) for each in file.includes) and not self.is_read_around(name)

    @property
    def may_read_any(self) -> bool:
        """Whether something in the file may read configurations of any name, or set them for others."""
        is_open = any(event.kind == "open" for event in self.scope.file.events or ())
        return is_open or "" in self.read or ANY in self.scope.file.source.text

    def may_be_substituted(self, name: str) -> bool:
        """Return whether the file has substitutions done in YAML, and some YAML of the repository asks for a name."""
        files = self.scope.files if self.scope.files.whole is None else PackageFiles(self.scope.files.whole)
        if SUBSTITUTED not in self.scope.file.source.text:
            return False
        return any(files.holds(each, f"$(var {name}".encode()) for each in files.every if each.endswith(YAML))

    @cached_property
    def read(self) -> Names:
        """The configurations that the file reads, "" for one of any name."""
        used = [each for each in self.scope.file.configurations() if each.arguments]
        names = {each.arguments[0].literal or "" for each in used if self.configurations.is_read(each.span)}
        return frozenset(names | {each.name for each in self.scope.file.events or () if each.kind == "use"})

    def is_taken(self, include: Include, name: str) -> bool:
        """Return whether an included file, which sees every argument, takes one; no other file is known to."""
        named = first_in(include.file, self.scope.file.path.rpartition("/")[0])
        return self.taken_by(named, name) if named is not None else self.is_declared_elsewhere(name)

    def taken_by(self, named: FileReference, name: str) -> bool:
        known = self.scope.workspace.included_arguments
        target = known.find(self.scope.package.name, named.package, named.path)
        if target is None:
            return name in known_arguments(named.package, named.path)
        place = target[0], target[1].source
        _, is_open = known.foreign_in(*place)
        return known.reads(*place, name, known_arguments) or (is_open and self.is_declared_elsewhere(name))

    def is_declared_elsewhere(self, name: str) -> bool:
        """Return whether another launch file of the workspace has an argument of a name."""
        return self.scope.workspace.launch.has(name, besides=self.configurations.file_name)

    def is_read_around(self, name: str) -> bool:
        """Return whether a file that includes this one may read an argument, which it sees from there on."""
        return self.configurations.is_included and self.is_declared_elsewhere(name)
