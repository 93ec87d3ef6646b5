"""What the oracles need around them: paths, environment, modules, versions."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import os
import sys


def prepare(installed):
    """Makes the modules of the oracles importable and quiet; `installed` is what the set-up script filled.

    Raises ModuleNotFoundError where one is missing.
    """
    sys.path.insert(0, os.path.join(installed, "site"))
    os.environ["XDG_CACHE_HOME"] = os.path.join(installed, "cache")
    # One thread, so that results do not depend on the number of processors.
    os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
    # Otherwise each process forks a daemon; what MPI leaves behind when a process just ends stays with the cache.
    os.environ["OMPI_MCA_ess_singleton_isolated"] = "1"
    os.environ["OMPI_MCA_orte_tmpdir_base"] = os.path.join(installed, "cache")

    import mpi4py.MPI  # noqa: F401, before PETSc: it asks for the thread level
    import petsc4py

    petsc4py.init(["-no_signal_handler"])
    import dolfinx  # noqa: F401
    import numpy  # noqa: F401
    import scipy  # noqa: F401
    import skfem  # noqa: F401


def versions():
    """Versions by name; those of a results file must be those of a live run."""
    from importlib.metadata import version

    import dolfinx
    import numpy
    import scipy
    from petsc4py import PETSc

    return {
        "python": ".".join(map(str, sys.version_info[:3])),
        "numpy": numpy.__version__,
        "scipy": scipy.__version__,
        "scikit-fem": version("scikit-fem"),
        "dolfinx": dolfinx.__version__,
        "petsc": ".".join(map(str, PETSc.Sys.getVersion())),
    }
