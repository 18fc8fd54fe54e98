"""Values of parameters as the text that a scene's XML has."""
import numbers


def text(value):
    """Returns the text of a number, a word, a truth value, or a sequence of these."""
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
        raise TypeError(f"{value!r} is no value of a parameter: a number, a text, a truth value or a sequence of these "
                        "is needed") from None
    return "{" + ", ".join(text(element) for element in elements) + "}"
