"""The driver as a process, on a shared machine or in a container: its command line and environment."""
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEPS = "Time Integrator/Time Step Control/"
# Open MPI for root and without pinned ranks; one thread a rank. Ranks that wait spin: for measurements.
BENCH_ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                         OPENBLAS_NUM_THREADS="1", OMPI_MCA_hwloc_base_binding_policy="none")
# Ranks that wait yield, so that more of them than cores do not starve each other.
ENVIRONMENT = dict(BENCH_ENVIRONMENT, OMPI_MCA_mpi_yield_when_idle="1")


def driver_command(driver, scene, arguments, settings, ranks):
    command = [] if ranks == 1 else ["mpirun", "-np", str(ranks), "--oversubscribe"]
    command += [driver, scene, "--quiet"] + arguments
    for setting in settings:
        command += ["--set", setting]
    return command
