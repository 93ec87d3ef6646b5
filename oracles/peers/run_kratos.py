"""An exported case by Kratos: run_kratos.py FOLDER contact [--times N]; writes kratos-contact.vtu there.

contact: Kratos's frictionless mortar contact with dual multipliers, augmented Lagrangian in its default version, all load in N steps, at whose
start alone pairs are sought. A rigid body is a row of fully held cells along the contact. In the plane its contact has edges with 2 nodes
alone, so that cells with 8 nodes are cut into 4 with 4 nodes. Sparse LU. Pressures are what the load leaves of Kratos's elastic forces of the
contact nodes, over their lengths.
"""

import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time

import exported  # first: one thread

import numpy as np

# Kratos is there where oracles/peers/setup.sh has put it.
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / ".python/kratos"))

try:
    import KratosMultiphysics as kratos
    from KratosMultiphysics import ContactStructuralMechanicsApplication  # registers its processes
    from KratosMultiphysics import StructuralMechanicsApplication as structural
    from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import StructuralMechanicsAnalysis
    from KratosMultiphysics.vtu_output_process import VtuOutputProcess
except ModuleNotFoundError as absent:
    exported.missing(f"Kratos ({absent.name})", "python3 -m pip install KratosContactStructuralMechanicsApplication KratosLinearSolversApplication")

STEPS, TOLERANCE = 100, 1e-9
LAWS = {"strain": "LinearElasticPlaneStrain2DLaw", "stress": "LinearElasticPlaneStress2DLaw"}
DISPLACEMENT = [kratos.DISPLACEMENT_X, kratos.DISPLACEMENT_Y]


class Scene(exported.Linear):
    """The scene in cells with 4 nodes, per unit of thickness, as Kratos reads it."""

    def __init__(self, problem):
        super().__init__(problem)
        self.bodies = int(self.body.max()) + 1
        self.force = problem.load().reshape(-1, 2) / problem.data["thickness"]
        self.loaded = np.flatnonzero(np.abs(self.force).max(axis=1)).tolist()

    def mesh(self):
        """Text of the mesh: nodes and cells count from 1."""
        lines = ["Begin ModelPartData", "End ModelPartData"]
        for number in range(self.bodies + 1):
            lines += [f"Begin Properties {number}", "End Properties"]
        lines += ["Begin Nodes", *(f"{n + 1} {self.points[n, 0]!r} {self.points[n, 1]!r} 0.0" for n in range(len(self.points))), "End Nodes"]
        cells = [" ".join(map(str, [k + 1, self.body[k] + 1, *(cell + 1)])) for k, cell in enumerate(self.cells)]
        lines += ["Begin Elements SmallDisplacementElement2D4N", *cells, "End Elements"]
        lines += ["Begin Conditions PointLoadCondition2D1N", *(f"{k + 1} 0 {n + 1}" for k, n in enumerate(self.loaded)), "End Conditions"]
        for body in range(self.bodies):
            own = np.flatnonzero(self.body == body)
            lines += part(f"body{body}", Nodes=np.unique(self.cells[own]), Elements=own)
        lines += part("loads", Nodes=self.loaded, Conditions=range(len(self.loaded)))
        for k, (first, second) in enumerate(self.contacts):
            lines += part(f"contact{k}", Nodes=np.unique([*first, *second])) + part(f"first{k}", Nodes=np.unique(first))
        return "\n".join([*lines, ""])

    def laws(self):
        """Text of the materials."""
        law, all_of_them = {"name": LAWS[self.problem.data["plane"]]}, []
        for body, (young, poisson) in enumerate(self.materials()):
            values = {"DENSITY": 1.0, "THICKNESS": 1.0, "YOUNG_MODULUS": young, "POISSON_RATIO": poisson}
            material = {"constitutive_law": law, "Variables": values, "Tables": {}}
            all_of_them.append({"model_part_name": f"Structure.body{body}", "properties_id": body + 1, "Material": material})
        return json.dumps({"properties": all_of_them})

    def parameters(self, place, load_steps):
        """Text of the parameters."""
        names = {str(k): [f"contact{k}"] for k in range(len(self.contacts))}
        firsts = {str(k): [f"first{k}"] for k in range(len(self.contacts))}
        contact = {"model_part_name": "Structure", "contact_model_part": names, "assume_master_slave": firsts, "contact_type": "Frictionless"}
        process = {"python_module": "alm_contact_process", "kratos_module": "KratosMultiphysics.ContactStructuralMechanicsApplication",
                   "process_name": "ALMContactProcess", "Parameters": contact}
        solver = {
            "solver_type": "Static", "model_part_name": "Structure", "domain_size": 2, "echo_level": 0, "analysis_type": "non_linear",
            "time_stepping": {"time_step": 1.0 / load_steps}, "clear_storage": True, "reform_dofs_at_each_step": True, "rotation_dofs": False,
            "model_import_settings": {"input_type": "mdpa", "input_filename": str(place / "scene")},
            "material_import_settings": {"materials_filename": str(place / "materials.json")},
            "contact_settings": {"mortar_type": "ALMContactFrictionless"}, "max_iteration": STEPS,
            "convergence_criterion": "contact_residual_criterion", "residual_relative_tolerance": TOLERANCE,
            "residual_absolute_tolerance": TOLERANCE, "linear_solver_settings": {"solver_type": "LinearSolversApplication.sparse_lu"}}
        whole = {"problem_name": "scene", "parallel_type": "OpenMP", "start_time": 0.0, "end_time": 1.0 - 0.5 / load_steps, "echo_level": 0}
        return json.dumps({"problem_data": whole, "solver_settings": solver, "processes": {"contact_process_list": [process]}})


def part(name, **members):
    """Text of a part of the mesh with members counted from 0."""
    lines = [f"Begin SubModelPart {name}"]
    for kind, numbers in members.items():
        lines += [f"Begin SubModelPart{kind}", *(str(int(n) + 1) for n in numbers), f"End SubModelPart{kind}"]
    return [*lines, "End SubModelPart"]


class Analysis(StructuralMechanicsAnalysis):
    """Kratos's analysis with the supports and loads of the scene, growing with its time."""

    def __init__(self, scene, place, load_steps):
        super().__init__(kratos.Model(), kratos.Parameters(scene.parameters(place, load_steps)))
        self.scene, self.load_steps, self.iterations = scene, load_steps, 0

    def ApplyBoundaryConditions(self):
        super().ApplyBoundaryConditions()
        scene, whole = self.scene, self.model["Structure"]
        share = whole.ProcessInfo[kratos.TIME]
        rigid = np.unique(scene.cells[scene.body >= len(scene.problem.data["young"])]).tolist()
        held = scene.problem.data["held"] + [(node, c, 0.0) for node in rigid for c in range(2)]
        for node, c, value in held:
            whole.Nodes[node + 1].Fix(DISPLACEMENT[c])
            whole.Nodes[node + 1].SetSolutionStepValue(DISPLACEMENT[c], share * value)
        for k, node in enumerate(scene.loaded):
            whole.GetCondition(k + 1).SetValue(structural.POINT_LOAD, [*(share * scene.force[node]), 0.0])
        if share > 1.5 / self.load_steps:
            return
        number = 0
        for side in scene.problem.data["tied"]:
            moves = DISPLACEMENT[side["component"]]
            first, *others = [whole.Nodes[n + 1] for n in side["nodes"] if not whole.Nodes[n + 1].IsFixed(moves)]
            for other in others:
                number += 1
                whole.CreateNewMasterSlaveConstraint("LinearMasterSlaveConstraint", number, first, moves, other, moves, 1.0, 0.0)

    def FinalizeSolutionStep(self):
        super().FinalizeSolutionStep()
        steps = self.model["Structure"].ProcessInfo[kratos.NL_ITERATION_NUMBER]
        if steps >= STEPS:
            raise RuntimeError(f"Kratos has not converged in {steps} iterations")
        self.iterations += steps


def pressed(scene, whole):
    """Contact forces on the nodes: what the load leaves of the elastic ones."""
    elastic, own = np.zeros((len(scene.points), 2)), kratos.Vector()
    for cell, nodes in zip(whole.Elements, scene.cells):
        cell.CalculateRightHandSide(own, whole.ProcessInfo)
        elastic[nodes] += np.array(own).reshape(4, 2)
    elastic[: len(scene.force)] += scene.force
    return -elastic.ravel()


def main(folder, method, times):
    """Solves, and writes the answer."""
    sys.stdout = os.fdopen(os.dup(1), "w")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # where Kratos itself writes
    kratos.Logger.GetDefaultOutput().SetSeverity(kratos.Logger.Severity.WARNING)
    problem = exported.Problem(folder)
    begin = time.perf_counter()
    scene = Scene(problem)
    with tempfile.TemporaryDirectory(prefix="kratos-") as name:
        place = pathlib.Path(name)
        (place / "scene.mdpa").write_text(scene.mesh(), encoding="ascii")
        (place / "materials.json").write_text(scene.laws(), encoding="ascii")
        analysis = Analysis(scene, place, round(times))
        analysis.Run()
        whole = analysis.model["Structure"]
        for n, pressure in enumerate(problem.pressures(pressed(scene, whole), scene.lengths())):
            whole.Nodes[n + 1].SetValue(kratos.PRESSURE, pressure)
        seconds = time.perf_counter() - begin
        write(analysis.model, place)
        file = f"kratos-{method}.vtu"
        shutil.copyfile(next(place.rglob("*_elements_*.vtu")), problem.folder / file)
    exported.report(code="kratos", version=".".join(re.findall(r"\d+", kratos.KratosGlobals.Kernel.Version())[:3]), file=file, iterations=analysis.iterations, seconds=seconds)


def write(model, place):
    """The field by Kratos's own output."""
    settings = {"model_part_name": "Structure", "file_format": "ascii", "output_precision": 12, "output_path": str(place / "fields"),
                "nodal_solution_step_data_variables": ["DISPLACEMENT"], "nodal_data_value_variables": ["PRESSURE"]}
    output = VtuOutputProcess(model, kratos.Parameters(json.dumps(settings)))
    for stage in "ExecuteInitialize", "ExecuteBeforeSolutionLoop", "ExecuteInitializeSolutionStep", "PrintOutput":
        getattr(output, stage)()


if __name__ == "__main__":
    exported.run(main, __doc__, ["contact"], "Kratos 10.4.4", "the load steps")
