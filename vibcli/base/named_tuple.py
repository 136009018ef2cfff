"""Named tuples as those of `typing`, made many times faster: a command makes a hundred of them before it works.

`typing` compiles each annotation, then a constructor for each class. Here annotations stay as they are written, and
one constructor serves all classes of as many fields: each takes its code, with the names of its own fields. Those of
up to eleven are compiled with this file.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing import NamedTuple as NamedTuple
else:
    from collections import _tuplegetter as field
    from functools import cache
    from types import FunctionType

    class _Fields(type):
        """Makes classes of what is written below the name NamedTuple: annotations are fields, what is set beside them
        their defaults. What it makes are plain types: of others `isinstance` is slow."""

        def __new__(kind, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> type:
            fields = tuple(body.get("__annotations__", ()))
            given = {each: body[each] for each in fields if each in body}
            if tuple(given) != fields[len(fields) - len(given):]:
                raise TypeError(f"{name}: a field without a default follows one with a default")
            body |= {each: field(index, "") for index, each in enumerate(fields)}
            body |= {"__slots__": (), "__new__": _constructor(name, fields, tuple(given.values())),
                     "__match_args__": fields, "_fields": fields, "_field_defaults": given}
            return type(name, (_Named,), body)

    def _constructor(name: str, fields: tuple[str, ...], defaults: tuple[Any, ...]) -> FunctionType:
        """`__new__` of a class: the values of the fields in their order, by place or by name."""
        model = _of_as_many(len(fields))
        code = model.__code__.replace(co_varnames=("_cls", *fields), co_name="__new__", co_qualname=f"{name}.__new__")
        return FunctionType(code, model.__globals__, "__new__", defaults)

    @cache
    def _of_as_many(number: int) -> FunctionType:
        if 0 < number <= len(_MODELS):
            return _MODELS[number - 1]
        values = "".join(f"_{index}, " for index in range(number))
        return eval(f"lambda _cls, {values}: new(_cls, ({values}))", {"new": new})

    new = tuple.__new__
    _MODELS = (
        lambda _cls, a: new(_cls, (a,)),
        lambda _cls, a, b: new(_cls, (a, b)),
        lambda _cls, a, b, c: new(_cls, (a, b, c)),
        lambda _cls, a, b, c, d: new(_cls, (a, b, c, d)),
        lambda _cls, a, b, c, d, e: new(_cls, (a, b, c, d, e)),
        lambda _cls, a, b, c, d, e, f: new(_cls, (a, b, c, d, e, f)),
        lambda _cls, a, b, c, d, e, f, g: new(_cls, (a, b, c, d, e, f, g)),
        lambda _cls, a, b, c, d, e, f, g, h: new(_cls, (a, b, c, d, e, f, g, h)),
        lambda _cls, a, b, c, d, e, f, g, h, i: new(_cls, (a, b, c, d, e, f, g, h, i)),
        lambda _cls, a, b, c, d, e, f, g, h, i, j: new(_cls, (a, b, c, d, e, f, g, h, i, j)),
        lambda _cls, a, b, c, d, e, f, g, h, i, j, k: new(_cls, (a, b, c, d, e, f, g, h, i, j, k)),
    )

    class _Named(tuple):
        __slots__ = ()

        @classmethod
        def _make(cls, values: Any) -> Any:
            return cls(*values)

        def _replace(self, **changes: Any) -> Any:
            values = tuple(map(changes.pop, self._fields, self))
            if changes:
                raise TypeError(f"{type(self).__name__} has no fields {', '.join(changes)}")
            return tuple.__new__(type(self), values)

        def _asdict(self) -> dict[str, Any]:
            return dict(zip(self._fields, self, strict=True))

        def __repr__(self) -> str:
            return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._asdict().items())})"

        def __getnewargs__(self) -> tuple[Any, ...]:
            return tuple(self)

    NamedTuple = type.__new__(_Fields, "NamedTuple", (), {})
