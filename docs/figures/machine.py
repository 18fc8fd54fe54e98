"""Describes the machine, and the state of the tree by git."""
import os
import re
import subprocess

from .table import ROOT

INSTRUCTION_SETS = {"avx512f": "AVX-512", "avx2": "AVX2", "sse2": "SSE2", "sve": "SVE", "asimd": "NEON"}  # best first
# Changes of these do not change a measurement: docs/measure writes them, and commands of the pages.
WRITTEN = (":(exclude)*.md", ":(exclude)docs/results", ":(exclude)docs/images", ":(exclude)results")


def describe():
    """Returns what a reader of a time must know about this machine."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        entries = dict(re.findall(r"^(.*?)\s*: *(.*)$", file.read(), re.MULTILINE))
    with open("/proc/meminfo", encoding="utf-8") as file:
        kilobytes = int(re.search(r"MemTotal:\s*(\d+)", file.read())[1])
    name = re.sub(r"\((R|TM)\)|\bProcessor\b|\bCPU\b|@.*", "", entries.get("model name", os.uname().machine))
    flags = entries.get("flags", entries.get("Features", "")).split()
    best = next((word for flag, word in INSTRUCTION_SETS.items() if flag in flags), "")
    return {"processor": " ".join(name.split()), "cores": len(os.sched_getaffinity(0)), "instruction_set": best,
            "memory_gb": round(kilobytes / 1e6, 1)}


def git(*words):
    """Returns exit status and output of git in the tree; the status is not 0 either if there is no git."""
    try:
        done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return 127, ""
    return done.returncode, done.stdout.strip()


def commit():
    """Returns the short hash of HEAD, or "unknown"."""
    status, text = git("rev-parse", "--short=7", "HEAD")
    return text if status == 0 else "unknown"


def has_changes():
    """Returns whether the tree has changes, beside those of documents, that HEAD does not have."""
    return bool(git("status", "--porcelain", "--", ".", *WRITTEN)[1])


def changed_since(old, code):
    """Returns how many files below `code` differ between a commit and HEAD; None if git does not know the commit."""
    status, names = git("diff", "--name-only", old, "HEAD", "--", *code)
    return len(names.splitlines()) if status == 0 else None
