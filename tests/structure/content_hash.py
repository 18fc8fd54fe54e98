"""A cache of checks that passed: what has not changed since then need not be checked again."""
import hashlib
import os
import pathlib


def hash_contents(root, files, *words):
    """Returns a hash of the words, and of the names and contents of the files, which are relative to `root`."""
    digest = hashlib.sha256("\0".join(words).encode())
    for file in sorted(files):
        digest.update(b"\0" + str(file).encode() + b"\0" + (pathlib.Path(root) / file).read_bytes())
    return digest.hexdigest()


class PassedChecks:
    """The hashes of checks that passed, one empty file each, in a folder of the user's cache.

    Every clone of the project shares the folder, so that a fresh clone need not repeat the checks.
    """

    def __init__(self, name):
        cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
        self._folder = pathlib.Path(cache) / name
        self._folder.mkdir(parents=True, exist_ok=True)

    def __contains__(self, key):
        return (self._folder / key).exists()

    def add(self, key):
        """Notes that the check with this hash passed."""
        (self._folder / key).touch()
