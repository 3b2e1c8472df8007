"""Variables of CMake: scopes of functions and folders, and their merge after branches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...light_dataclasses import dataclass, field
from .branch_values import merge_branches
from .values import Value

Snapshot = tuple[dict[str, Value], ...]


@dataclass
class VariableScope:
    """The variables of a function or a folder; others are looked up in the enclosing scope."""

    around: VariableScope | None = None
    variables: dict[str, Value] = field(default_factory=dict)

    def chain(self) -> Iterator[VariableScope]:
        scope: VariableScope | None = self
        while scope is not None:
            yield scope
            scope = scope.around

    def get(self, name: str) -> Value | None:
        """Return a variable's value, None where it was never set."""
        return next((scope.variables[name] for scope in self.chain() if name in scope.variables), None)

    def set(self, name: str, value: Value) -> None:
        self.variables[name] = value

    def unset(self, name: str) -> None:
        self.variables[name] = ()

    def save(self) -> Snapshot:
        return tuple(dict(scope.variables) for scope in self.chain())

    def restore(self, saved: Snapshot) -> None:
        for scope, variables in zip(self.chain(), saved, strict=True):
            scope.variables = dict(variables)

    def unite(self, ends: Sequence[Snapshot]) -> int:
        """Merge the variables of several branches; what differs becomes `maybe` or unknown.

        Return how many words were compared for that.
        """
        compared = 0
        for depth, scope in enumerate(self.chain()):
            levels = [end[depth] for end in ends]
            compared += sum(map(len, levels)) >> 1
            scope.variables = {}
            for name in dict.fromkeys(name for level in levels for name in level):
                values = [level.get(name, ()) for level in levels]
                same = all(value is values[0] for value in values)
                compared += 0 if same else sum(map(len, values))
                scope.variables[name] = values[0] if same else merge_branches(values)
        return compared
