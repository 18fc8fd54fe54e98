#!/usr/bin/python3
"""Checks that each class of lib has its test.

    tests/structure/class_tests_test.py

lib/<folder>/<name>.hpp is tested by tests/<folder>/<name>_test.cpp if it has a source file <name>.cpp, or if it defines
a class or a class template. Headers that only have structs of data, declarations or function templates are tested with
what uses them. `elsewhere` names the test of a header whose test has another name; `missing` lists the headers that no
test is about yet. The exit status is 1 if a header has no test and is in neither table, or if a table is out of date.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import LIB, ROOT, is_header_of_lib, list_files  # noqa: E402

TESTS = ROOT / "tests"
COMMENT = re.compile(r"//.*")
CLASS = re.compile(r"^class\s+\w+[^;{()]*\{", re.MULTILINE)
CLASS_TEMPLATE = re.compile(r"^template\s*<[^;{]*>\s*(class|struct)\s+\w+[^;{()]*\{", re.MULTILINE)

# By header: the test, as a path below tests, and what that test shows of the header.
elsewhere = {
    "mesh/merged_parts.hpp": ("scene/read/mesh_parts_test.cpp", "parts that share faces, and those that do not fit"),
    "base/memory_record.hpp": ("base/snapshot_test.cpp", "values by path, saved and restored"),
    "discretization/hanging_corners.hpp": ("discretization/coarse_space_test.cpp", "linear cells that conform"),
    "mesh/splitting/longest_edges.hpp": ("mesh/splitting/refine_simplices_test.cpp", "neighbours that agree"),
    "run/energies.hpp": ("run/stages_test.cpp", "energies that a stage begins with"),
    "run/handover.hpp": ("run/stages_test.cpp", "stages that go on from each other"),
    "run/history_row.hpp": ("run/run_test.cpp", "rows of history.csv"),
    "run/stage_ends.hpp": ("run/stages_test.cpp", "ends of stages, and restarts in each"),
    "fem/cells/prisms.hpp": ("fem/cells/simplices_test.cpp", "all shapes"),
    "fem/cells/pyramids.hpp": ("fem/cells/simplices_test.cpp", "all shapes"),
    "fem/cells/tetrahedra.hpp": ("fem/cells/simplices_test.cpp", "all shapes"),
    "fem/pyramid_functions.hpp": ("fem/cells/simplices_test.cpp", "as the functions of pyramids"),
    "fem/simplex_nodes.hpp": ("fem/cells/simplices_test.cpp", "places of nodes; sides in cell_info_test.cpp"),
    "fem/simplex_rules.hpp": ("fem/cells/simplices_test.cpp", "all rules; of triangles in cells/triangles_test.cpp"),
    "io/geo_script.hpp": ("io/drawing_test.cpp", "scripts that start programs, and the files that they name"),
    "io/file_cells.hpp": ("io/gmsh_mesh_test.cpp", "gmsh's cells; those of Exodus in exodus_test.cpp"),
    "io/msh2_sections.hpp": ("io/gmsh_mesh_test.cpp", "files of gmsh"),
    "io/msh_nodes.hpp": ("io/msh_file_test.cpp", "messages; nodes in gmsh_mesh_test.cpp"),
    "mesh/added_nodes.hpp": ("mesh/cell_order_test.cpp", "nodes and sets"),
    "mesh/curved_cells.hpp": ("io/gmsh_mesh_test.cpp", "straight and round edges"),
    "mesh/middles.hpp": ("mesh/cell_order_test.cpp", "linear cells; others in io/exodus_test.cpp and gmsh_mesh_test.cpp"),
    "fem/cell_traits.hpp": ("fem/cell_info_test.cpp", "traits of all types; inside or not in cells/triangles_test.cpp and simplices_test.cpp"),
    "fem/cells/hexahedra.hpp": ("fem/cell_info_test.cpp", "sides of all types"),
    "fem/cells/quadrilaterals.hpp": ("fem/cell_info_test.cpp", "sides of all types"),
    "study/common/study_run.hpp": ("study/compare/study_test.cpp", "the scenes of a study's runs"),
    "solve/direct/first_rank_factorization.hpp": ("solve/direct/direct_solver_test.cpp", "all of its kinds solve"),
    "solve/iterative/single_products.hpp": ("balance/tangent_operator_test.cpp", "products in both precisions"),
    "solve/direct/selected_entries.hpp": ("solve/direct/collected_matrix_test.cpp", "some entries, in another order"),
    "solve/loaded/muelu_factory.hpp": ("solve/multigrid_test.cpp", "solves by MueLu"),
    "solve/loaded/mumps_factorization.hpp": ("solve/solver_library_test.cpp", "both precisions"),
    "solve/loaded/stratimikos_builder.hpp": ("solve/solver_library_test.cpp", "lists, and one that it refuses"),
    "interaction/slip_response.hpp": ("interaction/elastic_slip_test.cpp", "responses of a slip"),
    "interaction/friction_step.hpp": ("term/wall/friction_term_test.cpp", "steps that stick, slide and end"),
    "term/friction_interaction.hpp": ("term/wall/friction_term_test.cpp", "terms that have it as their base"),
    "term/wall/friction_points.hpp": ("term/wall/friction_term_test.cpp", "points that stick, slide and are accepted"),
    "term/wall/point_matrices.hpp": ("term/wall/curved_surface_term_test.cpp", "products of actions"),
    "interaction/law_history.hpp": ("interaction/damage_law_test.cpp", "traits; a law with a history"),
    "interaction/law_parameters.hpp": ("interaction/laws_test.cpp", "parameters that are refused"),
    "io/hdf5_image.hpp": ("io/hdf5_series_test.cpp", "frames that the ordinary HDF5 driver reads; full disks"),
    "material/elastic_law.hpp": ("material/catalogue_test.cpp", "every law behind the interface"),
    "term/admissibility.hpp": ("model/crossing_test.cpp", "an interface; gaps and passages of surfaces"),
    "term/coupling.hpp": ("term/pair/pair_term_test.cpp", "an interface; stencils of two surfaces"),
    "term/surface_report.hpp": ("model/interaction_group_test.cpp", "an interface; numbers of all interactions"),
    "state/history.hpp": ("state/moved_test.cpp", "columns by kind; histories of states"),
    "state/place.hpp": ("time/interleaved_test.cpp", "places and memories of steps that alternate"),
    "model/state_report.hpp": ("model/model_test.cpp", "energies, momenta and fields of states"),
    "model/term_sums.hpp": ("model/model_test.cpp", "forces and tangents of all terms together"),
    "model/traits.hpp": ("time/compatibility_test.cpp", "what a scheme asks a model"),
    "scene/examine/pair_numbers.hpp": ("scene/explain/regime_test.cpp", "radii and moduli of pairs"),
    "scene/examine/surface_shape.hpp": ("scene/examine/characteristic_numbers_test.cpp", "radii and extents of surfaces"),
    "model/branch_reports.hpp": ("run/relaxation_watch_test.cpp", "stresses of branches"),
    "term/force_term.hpp": ("model/model_test.cpp", "an interface; forces, tangents and actions of all terms"),
    "term/rate_term.hpp": ("term/body/viscous_term_test.cpp", "an interface; viscosity behind it"),
    "term/body/batch_ends.hpp": ("term/body/elastic_term_test.cpp", "segments of all rules"),
    "term/body/body_cells.hpp": ("term/body/elastic_term_test.cpp", "cells of all types"),
    "term/body/body_cells_of.hpp": ("term/body/elastic_term_test.cpp", "cells of all types"),
    "term/body/elastic_term_impl.hpp": ("element/locking_remedies_test.cpp", "remedies for locking"),
    "term/body/elasticity_in.hpp": ("term/body/elastic_term_test.cpp", "energies and means of cells"),
    "term/body/branch_points.hpp": ("term/body/maxwell_term_test.cpp", "branches of blocks of all dimensions"),
    "term/body/kept_action.hpp": ("term/body/maxwell_term_test.cpp", "products and diagonals against the matrix"),
    "term/pair/pair_slip.hpp": ("term/pair/pair_friction_test.cpp", "slips, forces, and bodies that turn as one"),
    "term/pair/pair_action.hpp": ("term/pair/pair_term_test.cpp", "products and diagonals against the matrix"),
    "term/pair/pair_points.hpp": ("term/pair/pair_term_test.cpp", "points of both surfaces in forces and tangents"),
    "term/end_scratch.hpp": ("term/wall/curved_sides_test.cpp", "ends with and without a start or a velocity"),
    "term/wall/side_action.hpp": ("term/wall/curved_surface_term_test.cpp", "products of actions"),
    "term/wall/side_ends.hpp": ("term/wall/curved_sides_test.cpp", "places at time points"),
    "term/wall/wall_sides.hpp": ("term/wall/surface_sides_test.cpp", "an interface; sides of all types"),
    "term/wall/curved_points.hpp": ("term/wall/curved_surface_term_test.cpp", "forces and tangents before obstacles"),
    "term/wall/moving_frame.hpp": ("term/wall/moved_interaction_test.cpp", "forces, tangents and work in the frame"),
    "term/body/block_cells.hpp": ("term/body/elastic_term_test.cpp", "terms of all formulations hold them"),
    "base/digest.hpp": ("checkpoint/seal_test.cpp", "seals hold checksums"),
    "base/error.hpp": ("parameters/validation_test.cpp", "most tests of refusals catch an InputError"),
    "base/memory.hpp": ("drivers/failures_test.cpp", "the message of a driver that finds no memory"),
    "base/record.hpp": ("checkpoint/checkpoint_file_test.cpp", "an interface; what a record writes comes back"),
    "mesh/fingerprint.hpp": ("checkpoint/checkpoint_file_test.cpp", "FingerprintTest"),
    "discretization/material_point.hpp": ("model/enriched_model_test.cpp", "probes interpolate an affine field"),
    "discretization/nodal_measure.hpp": ("model/enriched_hexahedra_test.cpp", "nodal volumes sum to the volume"),
    "element/enhanced_kernel.hpp": ("element/locking_kernels_test.cpp", "tests both remedies for locking"),
    "element/mean_dilatation_kernel.hpp": ("element/locking_kernels_test.cpp", "tests both remedies for locking"),
    "fem/contact_elements.hpp": ("fem/reference_elements_test.cpp", "ContactElementTest"),
    "element/displacement_gradient.hpp": ("element/revolved_kernels_test.cpp", "rings; plane bodies by the other kernels"),
    "fem/revolved.hpp": ("element/revolved_kernels_test.cpp", "volumes of rings"),
    "fem/shape_table.hpp": ("fem/reference_elements_test.cpp", "tables integrate quadratics"),
    "fem/ties.hpp": ("fem/contact_hexahedra_test.cpp", "tied edges"),
    "io/exodus_mesh.hpp": ("io/exodus_test.cpp", "meshes that are written, read and refused"),
    "io/exodus_topology.hpp": ("io/exodus_test.cpp", "blocks of points, lines, faces, triangles and tetrahedra"),
    "io/field_file.hpp": ("io/hdf5_fields_test.cpp", "an interface; frames in both formats"),
    "io/hdf5_rows.hpp": ("io/hdf5_series_test.cpp", "sets that the ordinary HDF5 driver finds"),
    "io/mesh_file.hpp": ("scene/read/scene_mesh_test.cpp", "meshes of gmsh and Exodus found and refused"),
    "io/hdf5_file.hpp": ("checkpoint/checkpoint_file_test.cpp", "checkpoints are their only files"),
    "material/strain_law.hpp": ("material/rubber_laws_test.cpp", "objectivity, limits, refusals; all laws in the catalogue"),
    "material/strain_state.hpp": ("material/isochoric_law_test.cpp", "invariants against longer numbers"),
    "material/symmetric_moduli.hpp": ("material/isochoric_law_test.cpp", "moduli against automatic differentiation"),
    "element/branch_sum.hpp": ("element/maxwell_point_test.cpp", "stress and moduli as derivatives"),
    "element/isochoric_strain.hpp": ("element/maxwell_point_test.cpp", "energies against longer numbers"),
    "element/moduli_product.hpp": ("element/cell_product_test.cpp", "products against the matrix"),
    "element/spatial_product.hpp": ("element/cell_product_test.cpp", "products against the matrix"),
    "element/cell_kernel.hpp": ("element/elastic_kernel_test.cpp", "forces and tangents of an element, put together"),
    "material/law_points.hpp": ("element/elastic_kernel_test.cpp", "stresses and moduli by all rules"),
    "material/point_law.hpp": ("material/catalogue_test.cpp", "every law behind the interface"),
    "material/points.hpp": ("element/elastic_kernel_test.cpp", "points at the ends of segments"),
    "material/discrete_neo_hooke.hpp": ("material/neo_hooke_test.cpp", "the tests of the discrete gradient"),
    "mesh/distributed_cells.hpp": ("mesh/distributed_mesh_test.cpp", "the cells and sides of each rank's part"),
    "mesh/enrichment/contact_nodes.hpp": ("mesh/enrichment/enrich_test.cpp", "the steps of enrich()"),
    "mesh/generators/spatula_pad.hpp": ("mesh/generators/spatula_parts_test.cpp", "the pad's outline and faces"),
    "mesh/mesh.hpp": ("mesh/generators/generators_test.cpp", "mostly data; numbers of cells and nodes"),
    "mesh/node_ties.hpp": ("mesh/tie_test.cpp", "NodeTiesTest"),
    "mesh/mortar/facing_parts.hpp": ("mesh/mortar/tied_surfaces_test.cpp", "what faces a side, and what does not"),
    "mesh/mortar/mortar_sums.hpp": ("mesh/mortar/tied_surfaces_test.cpp", "constant stress comes back"),
    "mesh/mortar/mortar_weights.hpp": ("mesh/mortar/tied_surfaces_test.cpp", "weights of surfaces, edges and corners"),
    "mesh/periodic_sides.hpp": ("verification/periodic_test.cpp", "waves, pressure and refusals"),
    "mesh/side_set_nodes.hpp": ("mesh/cell_order_test.cpp", "node sets of sides get the middles"),
    "adapt/bulk.hpp": ("adapt/wished_splits_test.cpp", "BulkStrainTest"),
    "adapt/field_at.hpp": ("adapt/split_mesh_test.cpp", "FieldAtTest"),
    "adapt/front.hpp": ("adapt/wished_splits_test.cpp", "FrontTest"),
    "adapt/momentum.hpp": ("adapt/moved_motion_test.cpp", "momenta that are kept"),
    "adapt/projection.hpp": ("adapt/moved_motion_test.cpp", "momenta and rigid motions on other meshes"),
    "adapt/whole_field.hpp": ("adapt/split_mesh_test.cpp", "WholeFieldTest"),
    "mesh/splitting/cell_splits.hpp": ("adapt/split_mesh_test.cpp", "CellSplitsTest"),
    "mesh/splitting/split_tree.hpp": ("adapt/split_mesh_test.cpp", "leaves at points and around cells"),
    "time/mass_solver.hpp": ("adapt/moved_motion_test.cpp", "projections with the consistent mass"),
    "mesh/splitting/cell_tree.hpp": ("mesh/splitting/refine_test.cpp", "the steps of refine()"),
    "mesh/splitting/hanging_nodes.hpp": ("mesh/splitting/refine_test.cpp", "fields across hanging sides"),
    "mesh/splitting/middle_nodes.hpp": ("mesh/splitting/refine_test.cpp", "nodes of whole meshes that are refined"),
    "mesh/splitting/refined_region.hpp": ("mesh/splitting/refine_test.cpp", "which cells are split, and refusals"),
    "mesh/tied_nodes.hpp": ("mesh/splitting/refine_test.cpp", "places and chains of hanging nodes"),
    "mesh/partition.hpp": ("mesh/local_mesh_test.cpp", "PartitionNodesTest"),
    "mesh/selection.hpp": ("mesh/enrichment/enrich_test.cpp", "SelectionTest"),
    "mesh/soundness.hpp": ("io/unsound_meshes_test.cpp", "each fault of a mesh"),
    "parameters/list_xml.hpp": ("scene/scene_file_test.cpp", "scenes are such files"),
    "parameters/parameter_text.hpp": ("parameters/validation_test.cpp", "values are read strictly"),
    "run/checkpoints.hpp": ("run/restart_refusal_test.cpp", "which checkpoints are kept"),
    "time/step_judge.hpp": ("run/run_test.cpp", "AdaptiveStepsFollowTheTolerance"),
    "time/equilibrium.hpp": ("verification/dead_load_test.cpp", "loads without an equilibrium"),
    "run/field_recorder.hpp": ("run/restart_test.cpp", "resumed frames are those of a run without a restart"),
    "scene/history_columns.hpp": ("run/interaction_columns_test.cpp", "columns of interactions, names that make none"),
    "run/history.hpp": ("run/run_test.cpp", "columns and rows of history.csv"),
    "run/run_measures.hpp": ("run/run_warnings_test.cpp", "RunMeasuresTest"),
    "run/run_clock.hpp": ("run/restart_test.cpp", "seconds of runs that go on"),
    "run/run_files.hpp": ("run/restart_refusal_test.cpp", "what a refused restart leaves in the folder"),
    "run/summary.hpp": ("drivers/ixos_test.cpp", "the keys of summary.json"),
    "scene/read/conditions.hpp": ("verification/driven_test.cpp", "motions and loads of scenes"),
    "scene/explain/documentation.hpp": ("drivers/ixos_test.cpp", "ixos --parameters and --template"),
    "scene/explain/explanation.hpp": ("drivers/ixos_test.cpp", "ixos --explain"),
    "scene/read/grips.hpp": ("verification/grips_test.cpp", "grips of scenes, and their refusals"),
    "scene/read/interactions.hpp": ("drivers/refusal_test.cpp", "interactions that are refused"),
    "scene/read/materials.hpp": ("drivers/refusal_test.cpp", "materials that are refused"),
    "scene/examine/mesh_inspection.hpp": ("io/unsound_meshes_test.cpp", "the warnings of a scene's mesh"),
    "scene/examine/symmetry_planes.hpp": ("scene/examine/notes_test.cpp", "what acts on a plane of symmetry"),
    "scene/read/rigid_body_loads.hpp": ("verification/rigid_bodies_test.cpp", "loads, springs and velocities of bodies"),
    "scene/read/rigid_body_settings.hpp": ("scene/read/rigid_bodies_test.cpp", "refusals of each entry"),
    "scene/read/mesh_sets.hpp": ("scene/read/scene_mesh_test.cpp", "sets take every parameter"),
    "scene/read/parameters.hpp": ("parameters/validation_test.cpp", "validates scenes against them"),
    "scene/read/probes.hpp": ("run/run_test.cpp", "columns of probes"),
    "scene/scene_changes.hpp": ("run/restart_refusal_test.cpp", "SceneChangesTest"),
    "scene/examine/scene_facts.hpp": ("scene/examine/warnings_test.cpp", "the facts behind each warning"),
    "scene/simulation.hpp": ("scenes/ball_test.cpp", "the tests of scenes construct it"),
    "scene/read/stop.hpp": ("run/run_test.cpp", "runs that a criterion ends"),
    "model/body_supports.hpp": ("verification/rigid_bodies_test.cpp", "a body on a spring, and on a base that moves"),
    "model/carried_nodes.hpp": ("time/rigid_bodies_test.cpp", "a plate that carries a block"),
    "model/supports.hpp": ("model/grips_test.cpp", "refusals of grips"),
    "mesh/overlaps.hpp": ("mesh/repeated_test.cpp", "OverlapsTest"),
    "scene/read/array_options.hpp": ("scene/read/mesh_array_test.cpp", "layouts and disorder"),
    "rigid/body_sight.hpp": ("time/rigid_bodies_test.cpp", "the border is the derivative of the residual"),
    "rigid/rigid_bodies.hpp": ("rigid/rigid_body_test.cpp", "RigidBodiesTest"),
    "solve/bordered/bordered_operator.hpp": ("time/rigid_bodies_test.cpp", "the border is the derivative of the residual"),
    "solve/bordered/bordered_solver.hpp": ("verification/rigid_bodies_test.cpp", "Newton's method converges, with and without a matrix"),
    "term/border.hpp": ("time/rigid_bodies_test.cpp", "the border is the derivative of the residual"),
    "term/wall/carried_body.hpp": ("time/rigid_bodies_test.cpp", "impacts keep energy and momenta; the border"),
    "term/wall/frame_motion.hpp": ("term/wall/moved_interaction_test.cpp", "prescribed; time/rigid_bodies_test.cpp has bodies"),
    "time/body_stage.hpp": ("time/rigid_bodies_test.cpp", "tumbling, its order, and the border"),
    "time/body_steps.hpp": ("time/rigid_bodies_test.cpp", "tumbling in many steps"),
    "time/carried_grips.hpp": ("time/rigid_bodies_test.cpp", "a plate that carries a block"),
    "solve/newton/admissible_line_search.hpp": ("solve/newton/newton_test.cpp", "steps that are halved, and steps that are lengthened"),
    "solve/assemblable_operator.hpp": ("balance/tangent_operator_test.cpp", "an interface of TangentOperator"),
    "solve/iterative/chebyshev_polynomial.hpp": ("solve/chebyshev_test.cpp", "the best polynomial of its degree"),
    "solve/iterative/chebyshev_preconditioner.hpp": ("solve/chebyshev_test.cpp", "the polynomial"),
    "solve/coarsenable_operator.hpp": ("solve/loaded/two_level_preconditioner_test.cpp", "the Galerkin product"),
    "solve/direct/direct_preconditioner.hpp": ("solve/multigrid_test.cpp", "a kept factorisation"),
    "solve/direct/factorization.hpp": ("solve/direct/direct_solver_test.cpp", "each factorisation solves"),
    "solve/iterative/kept_preconditioner.hpp": ("time/repeated_steps_test.cpp", "comes back with a step that is repeated"),
    "solve/kept_state.hpp": ("solve/multigrid_test.cpp", "families of matrices"),
    "solve/direct/klu2_repair.hpp": ("solve/direct/direct_solver_test.cpp", "the repaired solver is the one in use"),
    "solve/iterative/lagged_solver.hpp": ("solve/multigrid_test.cpp", "LaggedSolverTest"),
    "solve/choice/linear_solver.hpp": ("solve/direct/direct_solver_test.cpp", "LinearSolverTest"),
    "solve/choice/linear_solver_defaults.hpp": ("solve/multigrid_test.cpp", "LinearSolverDefaultsSerialTest"),
    "solve/newton/nonlinear_problem.hpp": ("solve/newton/newton_test.cpp", "an interface; problems with known solutions"),
    "solve/iterative/rigid_body_modes.hpp": ("solve/multigrid_test.cpp", "the modes carry no elastic force"),
    "solve/choice/problem_size.hpp": ("solve/semi_discrete_preconditioner_test.cpp", "solvers of models without a scene"),
    "study/advice/advice_runs.hpp": ("study/advice/advice_test.cpp", "runs of advices, reused, failed and perturbed"),
    "study/advice/advice_search.hpp": ("study/advice/advice_test.cpp", "searches on formulas"),
    "study/common/run_pool.hpp": ("drivers/study_test.cpp", "whole studies; advice_test.cpp has those of advices"),
    "study/common/history_table.hpp": ("study/compare/study_test.cpp", "tables read back"),
    "study/compare/study_result.hpp": ("study/compare/study_test.cpp", "recommendation and files"),
    "study/scan/scan.hpp": ("drivers/scan_test.cpp", "whole scans"),
    "study/scan/scan_table.hpp": ("drivers/scan_test.cpp", "scan.csv and the table of the command"),
    "study/common/results_folder.hpp": ("drivers/study_test.cpp", "ResultsOfAnotherStudyStay; two processes in one folder"),
    "study/compare/study_runner.hpp": ("drivers/study_test.cpp", "whole studies"),
    "units/dimension.hpp": ("units/unit_system_test.cpp", "DimensionTest"),
    "units/documented_unit.hpp": ("units/unit_system_test.cpp", "DocumentedUnitTest"),
    "units/result_units.hpp": ("units/unit_system_test.cpp", "ResultUnitsTest"),
    "scene/read/unit_uses.hpp": ("scene/read/scene_units_test.cpp", "uses decide the units of loads and histories"),
    "scene/explain/si_explanation.hpp": ("drivers/ixos_test.cpp", "ixos --explain"),
    "term/interaction.hpp": ("verification/solid_contact_test.cpp", "an interface; its reports of parallel sides"),
    "term/wall/surface_terms.hpp": ("model/enriched_hexahedra_test.cpp", "forces are gradients of energies"),
    "term/term.hpp": ("scene/costs_test.cpp", "an interface; counts its calls"),
    "time/catalogue.hpp": ("time/schemes_test.cpp", "tests every scheme of the catalogue"),
    "rule/row_on_states.hpp": ("rule/row_test.cpp", "evaluation on states"),
    "time/stage_problem.hpp": ("time/stage_potential_test.cpp", "residual, potential and relaxed tangent"),
    "time/table.hpp": ("time/schemes_test.cpp", "consistent and inconsistent tables"),
}

# Headers that are only used in tests, or in none: each still needs its own.
missing = []


def name_test(header):
    """Returns the path below tests of a header's own test."""
    return header.removesuffix(".hpp") + "_test.cpp"


def has_test(header):
    """Returns whether a header has its own test."""
    return (TESTS / name_test(header)).is_file()


def needs_test(header):
    """Returns whether a header has a source file, or defines a class or a class template."""
    text = COMMENT.sub("", (LIB / header).read_text(encoding="utf-8"))
    return (LIB / header).with_suffix(".cpp").is_file() or any(p.search(text) for p in (CLASS, CLASS_TEMPLATE))


def check_entry(table, header):
    """Returns why a header should not be in that table; an empty string if it should."""
    if not is_header_of_lib(header):
        return f"lib/{header} does not exist: delete or rename its entry in {table}"
    if has_test(header):
        return f"lib/{header} has its test, tests/{name_test(header)}: delete its entry in {table}"
    if not needs_test(header):
        return f"lib/{header} needs no test: delete its entry in {table}"
    return ""


def check_tables():
    """Yields a message for each entry of the two tables that is out of date."""
    for table, headers in (("elsewhere", elsewhere), ("missing", missing)):
        yield from filter(None, (check_entry(table, header) for header in headers))
    for header in sorted(set(missing) & set(elsewhere)):
        yield f"lib/{header} is in both tables: delete one entry"
    for header, (test, _) in elsewhere.items():
        if not (TESTS / test).is_file():
            yield f"tests/{test} does not exist: name the test of lib/{header} in elsewhere"


def main():
    headers = [header for header in list_files(".hpp") if needs_test(header)]
    problems = list(check_tables())
    for header in headers:
        if not has_test(header) and header not in elsewhere and header not in missing:
            problems.append(f"lib/{header} has no test: write tests/{name_test(header)}, or name in elsewhere the test "
                            "that covers it")
    for header in missing:
        print(f"lib/{header} still needs tests/{name_test(header)}")
    if problems:
        sys.exit("\n".join(f"class_tests_test.py: {problem}" for problem in problems))
    print(f"{len(headers)} headers: {sum(map(has_test, headers))} have their own test, {len(elsewhere)} another, "
          f"{len(missing)} none")


if __name__ == "__main__":
    main()
