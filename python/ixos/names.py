"""Names of scenes as names of Python: "Young's Modulus" is youngs_modulus."""
import keyword
import re


def identifier(name):
    """Returns the name in lower case; without apostrophes, with underscores for all else that no identifier has."""
    word = re.sub(r"\W+", "_", name.replace("'", "").lower()).strip("_")
    return word + "_" if keyword.iskeyword(word) else word
