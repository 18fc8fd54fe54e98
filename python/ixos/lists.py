"""The lists of a scene as classes, made from the catalogues: one for each list, with a property for each parameter.

A list is a place in a scene, not a copy. `scene.time_integrator.type` and `scene["Time Integrator/Type"]` are the same
parameter. A parameter that the scene does not give has its default; None, where it must be given. Setting None gives
the default back.
"""
import contextlib

from . import _core
from .names import identifier
from .values import text


@contextlib.contextmanager
def unchanged_if_refused(core):
    """Restores a scene if what is done with it raises an exception."""
    before = core.copy()
    try:
        yield
    except Exception:
        core.assign(before)
        raise


def _documentation(name, entry):
    """The text of a parameter: its name in XML, type, default, what is allowed, meaning."""
    default = "must be given" if entry["default"] is None else f"default {entry['default']!r}"
    allowed = f" Allowed: {entry['allowed']}." if entry["allowed"] else ""
    return f"{name} ({entry['type']}, {default}). {entry['documentation']}{allowed}"


class List:
    """A list of parameters in a scene."""

    _description = {"parameters": {}, "lists": {}, "free_form": True}
    _classes = {}  # by name of a sublist; "<any name>" for names that the scene chooses
    _identifiers = {}

    def __init__(self, core, path=()):
        object.__setattr__(self, "_core", core)
        object.__setattr__(self, "_path", list(path))

    def _is_list(self, name):
        return name in self._classes or (name not in self._description["parameters"] and (
            "<any name>" in self._classes or self._core.has_list([*self._path, name])))

    def _sublist(self, name):
        return self._classes.get(name, self._classes.get("<any name>", List))(self._core, [*self._path, name])

    def _name(self, key):
        """The name in XML of an identifier."""
        if key in self._identifiers:
            return self._identifiers[key]
        return next((name for name in self if identifier(name) == key), key)

    def _place(self, key):
        """The list and the name of "List/Sublist/Name"."""
        *lists, name = key.split("/")
        here = self
        for word in lists:
            here = here._sublist(word)
        return here, name

    def __getitem__(self, key):
        here, name = self._place(key)
        if here._is_list(name):
            return here._sublist(name)
        value = here._core.get(here._path, name)
        if value is None:
            here._core.check_name(here._path, name)
            value = here._description["parameters"].get(name, {}).get("default")
        return value

    def __setitem__(self, key, value):
        here, name = self._place(key)
        if isinstance(value, List):
            value = value._as_dict()
        with unchanged_if_refused(self._core):
            if value is None:
                here._unset(name)
            elif isinstance(value, dict):
                here._core.remove(here._path, name)
                here._fill(name, value)
            else:
                place = "/".join([*here._path, name])
                here._core.set(place + "=" + text(value, place))

    def _unset(self, name):
        """Gives a parameter or list its default. Raises InputError for a name that the scene cannot have."""
        if not self._core.remove(self._path, name) and not self._is_list(name):
            self._core.check_name(self._path, name)

    def _fill(self, name, values):
        """Makes a list from a dictionary. The validation refuses parameters of other choices, as in XML."""
        path = [*self._path, name]
        self._core.make(path)
        inner = self._sublist(name)
        for key, value in values.items():
            known = inner._identifiers.get(key, key)
            if isinstance(value, dict):
                inner._fill(known, value)
            elif value is None:
                inner._unset(known)
            else:
                self._core.put(path, known, text(value, "/".join([*path, known])))

    def __delitem__(self, key):
        here, name = self._place(key)
        if not here._core.remove(here._path, name):
            raise KeyError(key)

    def __contains__(self, key):
        here, name = self._place(key)
        return name in list(here)

    def __iter__(self):
        """The names of the parameters and lists that the scene gives."""
        return iter(self._core.names(self._path))

    def __len__(self):
        return len(self._core.names(self._path))

    def __getattr__(self, key):
        if key.startswith("_"):
            raise AttributeError(key)
        name = self._name(key)
        if name == key and name not in self:
            where = "/".join(self._path) or "the scene"
            raise AttributeError(f"{where} has no \"{key}\"; there are: {', '.join(self.__dir__())}")
        return self[name]

    def __setattr__(self, key, value):
        self[self._name(key)] = value

    def __delattr__(self, key):
        del self[self._name(key)]

    def __dir__(self):
        given = [identifier(name) for name in self]
        functions = [name for name in super().__dir__() if not name.startswith("_")]
        return sorted({*self._identifiers, *functions, *(word for word in given if word.isidentifier())})

    def _ipython_key_completions_(self):
        return sorted({*self._description["parameters"], *self, *self._classes} - {"<any name>"})

    def _as_dict(self):
        """Returns the given values as dictionaries of names in XML."""
        return {name: self[name]._as_dict() if self._core.has_list([*self._path, name]) else self[name]
                for name in self}

    def __repr__(self):
        lines = [f"{'/'.join(self._path) or 'Scene'}:"]
        for name in self:
            here = self[name]
            lines += [f"  {line}" for line in (repr(here).replace("/".join([*self._path, name]) + ":", name + ":", 1)
                                               if isinstance(here, List) else f"{name} = {here!r}").split("\n")]
        return "\n".join(lines)


def _parameter(name, entry):
    return property(lambda self: self[name], lambda self, value: self.__setitem__(name, value),
                    lambda self: self.__setitem__(name, None), _documentation(name, entry))


def _list(name, description):
    return property(lambda self: self[name], lambda self, value: self.__setitem__(name, value),
                    lambda self: self.__setitem__(name, None), f"{name}. {description['documentation']}")


def make_class(name, description):
    """Returns a subclass of List for one list of valid parameters, and such classes for the lists in it."""
    inner = {key: make_class(name + "".join(word.capitalize() for word in identifier(key).split("_")), entry)
             for key, entry in description["lists"].items()}
    members = {identifier(key): _parameter(key, entry) for key, entry in description["parameters"].items()}
    members.update({identifier(key): _list(key, entry) for key, entry in description["lists"].items()
                    if key != "<any name>"})
    identifiers = {identifier(key): key for key in [*description["parameters"], *description["lists"]]
                   if key != "<any name>"}
    return type(name, (List,), {**members, "__doc__": description.get("documentation", "A scene."),
                                "__module__": __name__, "_description": description, "_classes": inner,
                                "_identifiers": identifiers})


SceneLists = make_class("Scene", _core.scene_parameters())
