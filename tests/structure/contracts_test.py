#!/usr/bin/python3
"""Checks that nothing that is made of others of its kind forgets a function of their contract.

    tests/structure/contracts_test.py

A wrapper is a class of lib that overrides Term::inside(), or that keeps another object of its base. A contract's
function with a default takes that default in silence where a wrapper does not override it, whatever the objects inside
do. So a wrapper overrides each of them; `on_purpose` names those that it leaves out, and why. Functions without a
default are the compiler's to check. The exit status is 1 if one is missing, or if the table names one that is not.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import LIB, ROOT  # noqa: E402

COMMENT = re.compile(r"//.*")
CLASS = re.compile(r"^(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::(?!:)\s*([^{;]*))?\{", re.MULTILINE)
VIRTUAL = re.compile(r"\bvirtual\b[^;{]*?(\w+)\s*\([^;{]*?\)\s*(?:const)?\s*(=\s*0)?\s*[;{]")
OVERRIDE = re.compile(r"(\w+)\s*\([^;{}]*?\)\s*(?:const)?\s*(?:override|final)\b")
FINAL = re.compile(r"(\w+)\s*\([^;{}]*?\)\s*(?:const)?\s*final\b")

# What each term has of its own, beside the terms inside it.
OWN = {"inside", "create_history", "create_memory"}

# By wrapper: the functions that it leaves at their defaults, and why.
FORCES = "forces and tangents are those of the double integral, of the distance only gaps count"
KEEPS = "the distance has neither friction nor damage, so that nothing lasts from step to step"
BODIES = "no rigid body carries a surface of a pair"
on_purpose = {
    "DoubleIntegral": {
        "add_border": BODIES,
        **dict.fromkeys(["add_force_and_keep", "add_kept_tangent", "create_kept", "is_gradient", "place"], FORCES),
        **dict.fromkeys(["begin_stage", "dissipates", "has_history", "has_state", "outlives_scene", "transfer"], KEEPS),
    },
    "TwoPasses": {**dict.fromkeys(["add_force_and_keep", "add_kept_tangent"], "create_kept() returns null"),
                  "add_border": BODIES},
}


def code_of(path):
    return COMMENT.sub("", path.read_text())


def body_from(text, start):
    """Returns the text from an open brace to the one that closes it."""
    depth = 0
    for place in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return text[start:place]
    return text[start:]


def classes():
    """Yields name, bases and body of the classes of lib."""
    for path in sorted(LIB.rglob("*.[hc]pp")):
        text = code_of(path)
        for match in CLASS.finditer(text):
            bases = re.findall(r"public\s+(?:\w+::)*(\w+)", match[2] or "")
            yield match[1], bases, body_from(text, match.end() - 1)


def defaults_of(contract, found):
    """Returns the functions with a default of a contract and of its bases."""
    if contract not in found:
        return set()
    bases, body = found[contract]
    names = {match[1] for match in VIRTUAL.finditer(body) if not match[2]}
    return names.union(*(defaults_of(base, found) for base in bases)) - set(FINAL.findall(body))


def is_wrapper(bases, body):
    """Returns whether a class with these bases and this body is a wrapper."""
    kept = "|".join(rf"_ptr<(?:const )?{base}>+\s*\w+_\b|\b{base}\s*[&*]\s*\w+_\s*;" for base in bases)
    return "inside() const override" in body or bool(kept and re.search(kept, body))


def main():
    found = {}
    for name, bases, body in classes():
        found.setdefault(name, (bases, body))
    wrappers = [name for name, (bases, body) in found.items() if is_wrapper(bases, body)]
    wrong = []
    for name in wrappers:
        bases, body = found[name]
        wanted = set().union(*(defaults_of(base, found) for base in bases)) - OWN
        missing = wanted - set(OVERRIDE.findall(body))
        listed = on_purpose.get(name, {})
        wrong += [f"{name} does not override {function}()" for function in sorted(missing - set(listed))]
        wrong += [f"on_purpose: {name} overrides {function}()" for function in sorted(set(listed) - missing)]
    wrong += [f"on_purpose: no wrapper {name}" for name in on_purpose if name not in wrappers]
    if len(wrappers) < 5:
        wrong.append(f"only {len(wrappers)} wrappers were found: does Term::inside() still exist?")
    for line in wrong:
        print(line)
    print(f"{len(wrappers)} wrappers: {', '.join(sorted(wrappers))}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
