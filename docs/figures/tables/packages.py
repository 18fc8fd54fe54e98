"""The table of docs/packages.md: instruction sets of the packages' library against a build for this processor."""
from ..runs import FINAL_TIME, Failure, forms, interleaved
from ..table import ROOT, Column, Table

LOADER = "/lib64/ld-linux-x86-64.so.2"
SCENES = {
    "ball": ("ball.xml", [f"{FINAL_TIME}=10"]),
    "strip": ("strip.xml", [f"{forms.RAMP}2", f"{FINAL_TIME}=20"]),
    "block, matrix-free": ("block-on-wall.xml",  # short steps, for which the solver is matrix-free
                           [*forms.SMALL_BLOCK, f"{forms.STEP}=0.005", f"{forms.RAMP}0.1", f"{FINAL_TIME}=1.5"]),
}
MASKS = {"x86-64-v4": "x86-64-v4", "x86-64-v3": "x86-64-v3", "x86-64": "none"}


def measure(context):
    """Runs each scene with the library of each build in turns."""
    portable = context.pick(ROOT / "build/portable", context.build)
    if not (portable / "drivers/ixos").exists():
        raise Failure("build/portable has no programs: docs/measure builds them without --no-build")
    programs = {"native": [context.program("ixos")]}
    programs.update((name, [LOADER, "--glibc-hwcaps-mask", mask, portable / "drivers/ixos"])
                    for name, mask in MASKS.items())
    rows = []
    for scene, (file, settings) in SCENES.items():
        settings = settings + context.pick([], [f"{FINAL_TIME}=0.1"])
        words = [word for setting in settings for word in ("--set", setting)]

        def seconds(name, file=file, words=words):
            return {"seconds": context.execute([*programs[name], forms.XML / file, *words, "--quiet", "--overwrite",
                                                "--output", context.folder / "run"]).cpu_seconds}

        samples = interleaved(programs, context.pick(5, 1), seconds)
        rows.append({"scene": scene, **{name: samples[name].ratio["seconds"] for name in MASKS},
                     "seconds": samples["native"].median["seconds"]})
    return rows


TABLES = [
    Table("instruction-sets", "docs/packages.md",
          [Column("scene"), *(Column(f"{name}, to native", "{:.2f}", name) for name in MASKS),
           Column("native, seconds", "{:.2f}", "seconds")],
          measure, ("lib", "cmake"), presets=("portable",), minutes=3),
]
