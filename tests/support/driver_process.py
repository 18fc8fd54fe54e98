"""The driver as a process, on a shared machine or in a container: its command line and environment."""
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEPS = "Time Integrator/Time Step Control/"


def test_environment():
    """Returns the variables that all tests set, in CMake and here."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "openmpi.env"), encoding="utf-8") as file:
        return dict(line.rstrip("\n").split("=", 1) for line in file if line[:1].isupper())


# Ranks that wait yield, so that more of them than cores do not starve each other.
ENVIRONMENT = {**os.environ, **test_environment(), "OMPI_MCA_mpi_yield_when_idle": "1"}
# For measurements: ranks that wait spin, and read each other's memory.
BENCH_ENVIRONMENT = {**os.environ, **{name: value for name, value in test_environment().items() if name not in
                                      ("OMPI_MCA_btl_vader_single_copy_mechanism", "OMPI_MCA_smsc")}}


def driver_command(driver, scene, arguments, settings, ranks):
    command = [] if ranks == 1 else ["mpirun", "-np", str(ranks)]
    command += [driver, scene, "--quiet"] + arguments
    for setting in settings:
        command += ["--set", setting]
    return command
