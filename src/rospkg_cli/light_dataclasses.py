"""Dataclasses that cost a twentieth to define: `dataclass`, `field` and `replace` as the standard library has them.

Every command defines some hundred of them before it does anything, so methods are shared, and `__init__` is compiled
when the first instance is made. Type checkers see the standard library's, and hold `frozen` true; at run time nothing
stops an assignment, for creating an instance would cost five times as much.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any


def field_names(kind: Any) -> tuple[str, ...]:
    """Return what `__init__` of a dataclass takes, the standard library's too; raises TypeError for another class."""
    if (own := getattr(kind, "__light_fields__", None)) is not None:
        return tuple(name for name, each in own.items() if each.init)
    from dataclasses import fields

    return tuple(each.name for each in fields(kind) if each.init)


if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
    from dataclasses import field as field
    from dataclasses import replace as replace
else:
    from functools import cache
    from operator import attrgetter
    from reprlib import recursive_repr
    from types import FunctionType

    MISSING = object()

    class Field:
        """What `field()` says of one field."""

        __slots__ = ("default", "default_factory", "init", "kw_only", "repr", "type")

        def __init__(self, default=MISSING, default_factory=MISSING, init=True, repr=True, kw_only=False):
            self.default, self.default_factory, self.type = default, default_factory, None
            self.init, self.repr, self.kw_only = init, repr, kw_only

    field = Field

    def dataclass(cls=None, /, *, frozen=False, slots=False, eq=True, order=False, kw_only=False):
        """Add the methods that the class does not define itself; `slots` makes a new class of it."""
        if cls is None:
            return lambda each: dataclass(each, frozen=frozen, slots=slots, eq=eq, order=order, kw_only=kw_only)
        own = own_fields(cls, kw_only)
        if slots:
            cls = with_slots(cls, own)
        defined = vars(cls)
        fields = {}
        for base in cls.__mro__[-1:0:-1]:
            fields |= vars(base).get("__light_fields__", {})
        fields |= own
        cls.__light_fields__ = fields
        cls.__field_values__ = attrgetter(*(fields or ["__class__"]))
        cls.__dataclass_fields__ = STANDARD_FIELDS
        cls.__match_args__ = tuple(fields)
        if "__init__" not in defined:
            cls.__init__ = init_at_first_use(cls)
        if "__repr__" not in defined:
            cls.__repr__ = shown
        if eq:
            add_comparisons(cls, defined, frozen, order)
        return cls

    def own_fields(cls, kw_only):
        """Return the fields that the class itself declares; takes away class attributes that are no defaults."""
        own = {}
        for name, kind in cls.__annotations__.items():
            if not (kind if isinstance(kind, str) else repr(kind)).startswith(("ClassVar", "typing.ClassVar")):
                default = vars(cls).get(name, MISSING)
                if isinstance(default, Field):
                    delattr(cls, name)
                else:
                    default = Field(default)
                default.kw_only, default.type = kw_only, kind
                own[name] = default
        return own

    def with_slots(cls, own):
        namespace = {k: v for k, v in vars(cls).items() if k not in own and k not in ("__dict__", "__weakref__")}
        namespace["__slots__"] = tuple(own)
        made = type(cls)(cls.__name__, cls.__bases__, namespace)
        made.__qualname__ = cls.__qualname__
        return made

    def add_comparisons(cls, defined, frozen, order):
        has_own_hash = "__hash__" in defined and not (defined["__hash__"] is None and "__eq__" in defined)
        if "__eq__" not in defined:
            cls.__eq__ = equal
        if not has_own_hash:
            cls.__hash__ = hashed if frozen else None
        if order:
            cls.__lt__, cls.__le__, cls.__gt__, cls.__ge__ = less, less_or_equal, greater, greater_or_equal

    def init_at_first_use(cls):
        def __init__(self, *arguments, **named):
            cls.__init__ = compiled_init(cls)
            cls.__init__(self, *arguments, **named)

        return __init__

    @cache
    def plain_code(count, has_post):
        """Return the code of an `__init__` with so many parameters, whose names are replaced for each class."""
        names = [f"field_{number}" for number in range(count)]
        body = [f"self.{name} = {name}" for name in names] + ["self.__post_init__()"] * has_post
        made = {}
        exec(f"def __init__(self, {', '.join(names)}):\n  " + "\n  ".join(body or ["pass"]), made)
        return made["__init__"].__code__

    def plain_init(cls, has_post):
        """Return what `compiled_init` does for fields without factories, ten times faster."""
        names = tuple(cls.__light_fields__)
        code = plain_code(len(names), has_post).replace(
            co_varnames=("self", *names), co_names=names + ("__post_init__",) * has_post
        )
        defaults = tuple(e.default for e in cls.__light_fields__.values() if e.default is not MISSING)
        return FunctionType(code, {}, "__init__", defaults)

    def compiled_init(cls):
        has_post = hasattr(cls, "__post_init__")
        if all(e.init and not e.kw_only and e.default_factory is MISSING for e in cls.__light_fields__.values()):
            return plain_init(cls, has_post)
        names, positional, keyword, body = {"MISSING": MISSING}, ["self"], [], []
        for name, each in cls.__light_fields__.items():
            value = name
            if each.default_factory is not MISSING:
                names[f"make_{name}"], default = each.default_factory, "=MISSING"
                value = f"make_{name}() if {name} is MISSING else {name}" if each.init else f"make_{name}()"
            elif each.default is not MISSING:
                names[f"default_{name}"], default = each.default, f"=default_{name}"
            else:
                default = ""
            if each.init:
                (keyword if each.kw_only else positional).append(name + default)
            if each.init or each.default_factory is not MISSING:
                body.append(f"self.{name} = {value}")
        if has_post:
            body.append("self.__post_init__()")
        parameters = ", ".join([*positional, *(["*", *keyword] if keyword else [])])
        exec(f"def __init__({parameters}):\n  " + "\n  ".join(body or ["pass"]), names)
        return names["__init__"]

    def replace(value, /, **changes):
        """Return a copy with some fields changed."""
        for name, each in value.__light_fields__.items():
            if each.init and name not in changes:
                changes[name] = getattr(value, name)
        return value.__class__(**changes)

    @recursive_repr()
    def shown(self):
        parts = (f"{name}={getattr(self, name)!r}" for name, each in self.__light_fields__.items() if each.repr)
        return f"{self.__class__.__qualname__}({', '.join(parts)})"

    def equal(self, other):
        if other.__class__ is not self.__class__:
            return NotImplemented
        values = self.__field_values__
        return values(self) == values(other)

    def hashed(self):
        return hash(self.__field_values__(self))

    def less(self, other):
        if other.__class__ is not self.__class__:
            return NotImplemented
        return self.__field_values__(self) < other.__field_values__(other)

    def less_or_equal(self, other):
        if other.__class__ is not self.__class__:
            return NotImplemented
        return self.__field_values__(self) <= other.__field_values__(other)

    def greater(self, other):
        return less(other, self)

    def greater_or_equal(self, other):
        return less_or_equal(other, self)

    class StandardFields:
        """`__dataclass_fields__`, made when `dataclasses.fields`, `is_dataclass` or `asdict` asks for it."""

        def __get__(self, instance, owner):
            import dataclasses

            unknown = dataclasses.MISSING
            specified = []
            for name, each in owner.__light_fields__.items():
                default = unknown if each.default is MISSING else each.default
                factory = unknown if each.default_factory is MISSING else each.default_factory
                made = dataclasses.field(default=default, default_factory=factory, init=each.init, repr=each.repr)
                specified.append((name, each.type, made))
            return dataclasses.make_dataclass(owner.__name__, specified, kw_only=True).__dataclass_fields__

    STANDARD_FIELDS = StandardFields()
