"""What meshio and pyvista read in a file of fields: points, cells, names, and the extremes of every field, as JSON."""
import json

import given

try:
    import meshio
    import numpy
    import pyvista
except ModuleNotFoundError as absent:
    given.missing(absent.name)

# A component by another way: von Mises from the components, by the calculator's own names.
FORMULA = "sqrt(0.5*((stress_xx-stress_yy)^2+(stress_yy-stress_zz)^2+(stress_zz-stress_xx)^2)+3*stress_xy^2)"


def extremes(fields):
    """Smallest and largest number of every field; what is not a number is left out."""
    return {name: [float(numpy.nanmin(values)), float(numpy.nanmax(values))] for name, values in fields.items()}


def by_meshio(path):
    mesh = meshio.read(path)
    cells = {name: values[0] for name, values in mesh.cell_data.items()}
    number = sum(len(block.data) for block in mesh.cells)
    return {"points": len(mesh.points), "cells": number, "point": extremes(mesh.point_data), "cell": extremes(cells)}


def by_pyvista(path):
    grid = pyvista.read(path)
    point = {name: grid.point_data[name] for name in grid.point_data}
    cell = {name: grid.cell_data[name] for name in grid.cell_data}
    return {"points": grid.n_points, "cells": grid.n_cells, "point": extremes(point), "cell": extremes(cell)}


def calculated(path):
    """Largest difference of `von_mises` and what VTK's calculator makes of the components, which ParaView's is built on."""
    from vtkmodules.vtkFiltersCore import vtkArrayCalculator

    grid = pyvista.read(path)
    calculator = vtkArrayCalculator()
    calculator.SetInputData(grid)
    for name in ["stress_xx", "stress_yy", "stress_zz", "stress_xy"]:
        calculator.AddScalarArrayName(name)
    calculator.SetFunction(FORMULA)
    calculator.SetResultArrayName("calculated")
    calculator.Update()
    found = pyvista.wrap(calculator.GetOutput())
    return float(numpy.max(numpy.abs(found.point_data["calculated"] - grid.point_data["von_mises"])))


path = given.file(__doc__)
print(json.dumps({"meshio": by_meshio(path), "pyvista": by_pyvista(path), "calculated": calculated(path)}))
