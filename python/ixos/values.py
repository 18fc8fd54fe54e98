"""Values of parameters as the text that a scene's XML has."""
import numbers

from ._core import InputError


def text(value, place):
    """Returns the text of a number, a word, a truth value, or a sequence of these. Messages name the place."""
    if isinstance(value, str):
        return value
    if type(value).__name__ in ("bool", "bool_"):  # Python's and NumPy's
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    try:
        elements = list(value)
    except TypeError:
        raise TypeError(f"{place}: {value!r} is no value of a parameter: a number, a text, a truth value or a sequence "
                        "of these is needed") from None
    return "{" + ", ".join(_element(element, place) for element in elements) + "}"


def _element(value, place):
    """Returns the text of an element. Raises InputError for one that would not come back as it is."""
    word = text(value, place)
    if not word or word != word.strip() or any(sign in word for sign in ",{}"):
        raise InputError(f"{place}: the element {value!r} is not possible; an element is a number, a truth value or a "
                         "text without commas, braces and blanks at its ends")
    return word
