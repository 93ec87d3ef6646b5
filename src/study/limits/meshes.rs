//! Limits of the mesh: cells that lock or are distorted, and meshes that differ on the two sides.

use crate::case::library::{Patch, TruncatedHertz};
use crate::case::{Check, Quantity, Reference};
use crate::elasticity::ElasticSystem;
use crate::error::{Error, Kind};
use crate::measure::{larger, largest, profile};
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::{
    Action, Component, Face, Grading, LARGEST_POISSON, Load, Place, Profile, Scene, Shape, Support, VectorField,
};
use crate::solve::run::INSIDE;
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::limits::push::{
    Limit, ORDERS, Push, Solved, against_hertz, exceeds, folded, meshed, number, percent, refused, size, told,
    told_with_remedy, within, worst,
};

/// Truncated Hertz on cells that hardly grow: what fails is then the cells' doing, not their sizes'.
fn on_even_cells(numbers: TruncatedHertz) -> Scene {
    let mut scene = numbers.scene();
    scene.grading = Grading { along: 1.3, depth: 1.25, ..scene.grading };
    scene
}

/// The discretisation of a mesh, assembled past the checks of the scene.
fn unchecked(scene: &Scene, mesh: Mesh, resolution: Resolution) -> Result<Discretisation, Error> {
    let system = ElasticSystem::assemble(scene, &mesh)?;
    Discretisation::of_system(scene.clone(), resolution, mesh, system)
}

/// Largest departure from the uniform pressure of the patch test; NaN where the run did not converge.
fn patch_error(numbers: &Patch, run: &Run) -> f64 {
    let departures = run.solution.points.iter().map(|point| (point.pressure / numbers.pressure - 1.0).abs());
    if run.solution.converged() { largest(departures) } else { f64::NAN }
}

/// Poisson's ratios, and one that is refused.
const POISSON: [f64; 5] = [0.3, 0.45, 0.49, 0.499, LARGEST_POISSON];
const BEYOND: f64 = 0.49999;
/// Error of p₀ and a that counts as locking.
const LOCKED: f64 = 0.03;

/// Largest departure of a pressure from its neighbours' line, over p₀.
fn departure(Solved { reference, run }: &Solved) -> f64 {
    profile::oscillation(&run.solution.points, INSIDE * reference.length) / reference.pressure
}

/// Bodies that hardly change their volume: ν towards 0.5 in plane strain.
pub(super) fn incompressible() -> Result<Limit, Error> {
    let numbers = |poisson: f64| TruncatedHertz { poisson, ..Default::default() };
    let meshes = [(16, Order::Linear), (8, Order::Quadratic)];
    let ratios = Push::of("ν", &POISSON, meshes, |poisson, (elements, order)| {
        Solved::on(&meshed(on_even_cells(numbers(poisson)), elements, order)?)
    })?;
    let beyond = meshed(numbers(BEYOND).scene(), 8, Order::Quadratic);
    let beyond = refused(beyond, "a body that keeps its volume")?;
    let [four, eight] = [0, 1].map(|k| ratios.onset(|found| found[k].is_off(LOCKED)));
    let close = |order: usize, quantity: &'static str, tolerance: f64, because: &'static str| {
        let hertz = Reference::analytic("Hertz, whose a depends on E/(1 − ν²) only", 0.0);
        Check::error(quantity, hertz, tolerance, because)
            .judge(worst(ratios.tried.iter().map(|(_, found)| &found[order])))
    };
    Ok(Limit {
        pushed: "ν towards 0.5 in plane strain",
        range: ratios.range("ν"),
        onset: format!("errors of p₀ and a beyond {}: 4-node cells {four}, 8-node cells {eight}", size(LOCKED)),
        seen: told(&beyond),
        instead: beyond.remedy,
        judged: vec![
            close(
                0,
                "largest error of p₀ and a on 4-node cells as ν tends to 0.5",
                5e-3,
                "16 cells per half-width; locking stiffens without bound as ν tends to 0.5",
            ),
            close(
                1,
                "largest error of p₀ and a on 8-node cells as ν tends to 0.5",
                2e-3,
                "8 cells per half-width; locking stiffens without bound as ν tends to 0.5",
            ),
            Check::at_most(
                "departure of a pressure from its neighbours' line over p₀",
                Reference::own("whatever ν", 0.02),
                "a smooth profile departs by its curvature, whatever ν",
            )
            .judge(largest(ratios.all().map(departure))),
        ],
        table: ratios.table(
            "Truncated Hertz by Poisson's ratio (errors against Hertz)",
            &[
                ("ν", |(poisson, _)| poisson.to_string()),
                ("4-node: p₀", |(_, [four, _])| percent(four.errors().peak)),
                ("a", |(_, [four, _])| percent(four.errors().half_width)),
                ("departure of neighbours", |(_, [four, _])| percent(departure(four))),
                ("8-node: p₀", |(_, [_, eight])| percent(eight.errors().peak)),
                ("a", |(_, [_, eight])| percent(eight.errors().half_width)),
                ("departure of neighbours", |(_, [_, eight])| percent(departure(eight))),
            ],
        ),
    })
}

/// Largest moves of inner nodes over their shortest edge.
const FRACTIONS: [f64; 8] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8];

/// Errors of a run, or the refusal of its mesh.
fn errors_or_refusal(result: &Result<Solved, Error>) -> String {
    let errors = |solved: &Solved| {
        let [peak, half_width] = solved.percents();
        format!("p₀ {peak}, a {half_width}")
    };
    result.as_ref().map_or_else(told, errors)
}

/// Inner nodes are moved until cells turn inside out.
pub(super) fn distorted() -> Result<Limit, Error> {
    let scene = on_even_cells(TruncatedHertz::default());
    let moves = Push::of("fraction", &FRACTIONS, ORDERS, |fraction, order| {
        let resolution = Resolution { elements: 8, refinement: 0, order };
        let mesh = Mesh::of(&scene, resolution)?.shaken(fraction);
        Ok(unchecked(&scene, mesh, resolution).and_then(|discretisation| Solved::on(&discretisation)))
    })?;
    let worst = worst(moves.all().filter_map(|result| result.as_ref().ok()));
    let refusals: Vec<&Error> = moves.all().filter_map(|result| result.as_ref().err()).collect();
    let others = refusals.iter().filter(|error| !matches!(error.kind, Kind::DegenerateCell)).count();
    let [four, eight] = [0, 1].map(|k| moves.onset(|results| results[k].is_err()));
    let [seen, instead] = told_with_remedy(refusals.last().copied());
    Ok(Limit {
        pushed: "distorted and inverted cells",
        range: moves.range("move of the inner nodes over their shortest edge"),
        onset: format!(
            "4-node: inverted {four}; 8-node: inverted {eight}; before, errors of p₀ and a are at most {}",
            size(worst)
        ),
        seen,
        instead,
        judged: vec![
            against_hertz(
                "largest error of p₀ and a on cells that are distorted but not inverted",
                worst,
                1e-2,
                "isoparametric cells keep linear fields; engineering tolerance of the paper's comparison",
            ),
            Check::none(
                "refusal that does not name an inverted cell",
                "the Jacobian determinant is looked at in every cell",
            )
            .asked_of(refusals.len())
            .judge(others as f64),
        ],
        table: moves.table(
            "Truncated Hertz on shaken meshes (errors against Hertz)",
            &[
                ("move / shortest edge", |(fraction, _)| number(*fraction)),
                ("4-node", |(_, [four, _])| errors_or_refusal(four)),
                ("8-node", |(_, [_, eight])| errors_or_refusal(eight)),
            ],
        ),
    })
}

/// Error of p₀ and a across the interface that counts as wrong.
const WRONG: f64 = 0.01;
/// Departure from a uniform pressure that round-off explains.
const ROUND_OFF: f64 = 1e-9;
/// Depth of the elements at the interface, second body over first.
const DEPTHS: [f64; 7] = [0.05, 0.2, 1.0, 2.0, 5.0, 10.0, 20.0];
/// Largest ratio at which 8-node cells must find the contact.
const MODERATE: f64 = 5.0;

/// The mesh with the nodes of its second body moved to `ratio` times their depth.
fn stretched(scene: &Scene, ratio: f64, resolution: Resolution) -> Result<Mesh, Error> {
    let mut mesh = Mesh::of(scene, resolution)?;
    let nodes = mesh.bodies[1].nodes.clone();
    mesh.points[nodes].iter_mut().for_each(|point| point[1] *= ratio);
    Ok(mesh)
}

/// Truncated Hertz and its mirror image, `ratio` times as high: each carries Hertz's tractions, and with twice the
/// curvature between them each does what it does on the rigid parabola.
fn two_blocks(ratio: f64) -> Scene {
    let numbers = TruncatedHertz::default();
    let side = numbers.size * numbers.half_width();
    let radius = 0.5 * numbers.radius;
    let mut scene = numbers.scene();
    let mut lower = scene.bodies[0].clone();
    lower.name = "lower block".into();
    lower.shape = Shape::Rectangle { x: [0.0, side], y: [-ratio * side, 0.0], contact: Face::Top };
    let corner = Place::Point([0.0, -ratio * side]);
    lower.supports.push(Support { at: corner, component: Component::Y, value: 0.0 });
    for load in &mut lower.loads {
        if let Load::OnSide { action: Action::Stress(field), .. } = load {
            let upper = field.0.clone();
            *field = VectorField::of(move |[x, y]: [f64; 2]| {
                let [along, across, shear] = upper([x, -y]);
                [along, across, -shear]
            });
        }
    }
    scene.bodies.push(lower);
    scene.contacts[0].second = Some(1);
    scene.contacts[0].profile = Profile::Parabola { radius };
    scene.reference.gap *= 2.0;
    scene
}

/// Elements of up to 1:20 across the interface.
pub(super) fn unequal_sizes() -> Result<Limit, Error> {
    let ratios = Push::of("ratio", &DEPTHS, ORDERS, |ratio, order| {
        let resolution = Resolution { elements: 8, refinement: 0, order };
        let mesh = stretched(&two_blocks(1.0), ratio, resolution)?;
        Solved::on(&unchecked(&two_blocks(ratio), mesh, resolution)?)
    })?;
    let patches = Push::of("ratio", &DEPTHS, ORDERS, |ratio, order| {
        let (numbers, resolution) = (Patch::default(), Resolution { elements: 3, refinement: 0, order });
        let mesh = stretched(&numbers.scene(), ratio, resolution)?;
        Ok(patch_error(&numbers, &Solved::on(&unchecked(&numbers.scene(), mesh, resolution)?)?.run))
    })?;
    let patch = largest(patches.all().copied());
    let moderate = ratios.tried.iter().filter(|(ratio, _)| *ratio <= MODERATE);
    let [four, eight] = [0, 1].map(|k| ratios.onset(|found| found[k].is_off(WRONG)));
    Ok(Limit {
        pushed: "element sizes across the interface",
        range: ratios.range("depth of the elements, second body over first"),
        onset: format!(
            "error beyond {}: 4-node {four}; 8-node {eight}; largest error of the patch test {}",
            size(WRONG),
            within(patch, ROUND_OFF)
        ),
        seen: format!("{}; only a finer mesh shows the error", ratios.last()[1].seen()),
        instead: format!("8-node cells, at most {} times as deep on one side", number(MODERATE)),
        judged: vec![
            Check::error(
                Quantity::at("largest |p − q| / q of the patch test", "ratios 1/20 to 20"),
                Reference::analytic("the uniform pressure", 0.0),
                ROUND_OFF,
                "exact but for round-off: tributary areas come from the interface alone",
            )
            .judge(patch),
            against_hertz(
                "largest error of p₀ and a on 8-node cells up to five times as deep on one side",
                worst(moderate.map(|(_, [_, eight])| eight)),
                WRONG,
                "engineering tolerance of the paper's comparison, 8 cells per half-width along the contact",
            ),
        ],
        table: ratios.table(
            "Two blocks with Hertz's tractions, the second stretched in depth (errors against Hertz)",
            &[
                ("depth, second / first", |(ratio, _)| number(*ratio)),
                ("4-node: p₀", |(_, [four, _])| percent(four.errors().peak)),
                ("a", |(_, [four, _])| percent(four.errors().half_width)),
                ("8-node: p₀", |(_, [_, eight])| percent(eight.errors().peak)),
                ("a", |(_, [_, eight])| percent(eight.errors().half_width)),
            ],
        ),
    })
}

/// Departure from a uniform pressure that the iteration, of tolerance 1e-9, explains.
const ITERATED: f64 = 1e-8;
/// Elements of the second body over those of the first.
const DENSITIES: [f64; 9] = [0.1, 0.2, 0.5, 0.8, 1.0, 1.25, 2.0, 2.3, 5.0];
/// Coarsest second body opposite which 8-node cells must find the contact.
const COARSE: f64 = 0.5;

/// What is found across meshes that do not match.
struct Across {
    /// Nodes of a cell.
    nodes: usize,
    /// Largest error of the patch test, by contact element.
    patch: [f64; 3],
    /// Two blocks with Hertz's tractions, the contact points on the first and on the second.
    blocks: [Solved; 2],
    /// Difference of the contact forces on the two bodies and of their moments, over the force and the force times the
    /// stretch: the larger of both runs.
    unbalanced: f64,
}

impl Across {
    fn at(density: f64, order: Order) -> Result<Self, Error> {
        let mut scene = two_blocks(1.0);
        scene.bodies[1].density = density;
        let [first, second] = [scene.clone(), exchanged(scene)].map(|scene| meshed(scene, 8, order));
        let (first, second) = (first?, second?);
        let blocks = [Solved::on(&first)?, Solved::on(&second)?];
        let [line, layer, node] = Element::ALL.map(|element| patch(element, order, density));
        Ok(Self {
            nodes: order.nodes_per_cell(),
            patch: [line?, layer?, node?],
            unbalanced: larger(unbalanced(&first, &blocks[0].run), unbalanced(&second, &blocks[1].run)),
            blocks,
        })
    }
}

/// The scene with the contact points on its second body.
fn exchanged(mut scene: Scene) -> Scene {
    (scene.contacts[0].first, scene.contacts[0].second) = (1, Some(0));
    scene.contacts[0].above = false;
    scene
}

fn patch(element: Element, order: Order, density: f64) -> Result<f64, Error> {
    let numbers = Patch::default();
    let mut scene = numbers.scene();
    scene.bodies[1].density = density;
    let formulation = Formulation::new(element, Iteration::Kinematic).tolerance(1e-9);
    Ok(patch_error(&numbers, &Run::of(&meshed(scene, 10, order)?, &formulation)?))
}

fn unbalanced(discretisation: &Discretisation, run: &Run) -> f64 {
    let of_body = |body: usize| {
        let offset = discretisation.condensed.offsets[body];
        let candidates = discretisation.mesh.bodies[body].candidates.iter().enumerate();
        candidates.fold([0.0; 2], |[force, moment], (index, candidate)| {
            let pressing = run.solution.contact_force[offset + index];
            [force + pressing, moment + pressing * candidate.coordinate]
        })
    };
    let ([force, moment], [other, opposite]) = (of_body(0), of_body(1));
    let arm = discretisation.scene.contact().stretch;
    larger(((force - other) / force).abs(), ((moment - opposite) / (force * arm)).abs())
}

/// Ratios at which cells of an order are wrong with points on either side: where those on the finer side are better,
/// and where not.
fn sides(densities: &Push<Across, 2>, order: usize) -> [Vec<f64>; 2] {
    let errors = |(density, found): &(f64, [Across; 2])| {
        let [first, second] = found[order].blocks.each_ref().map(|solved| solved.errors().largest());
        let [finer, coarser] = if *density < 1.0 { [first, second] } else { [second, first] };
        exceeds(larger(finer, coarser), WRONG).then_some((*density, finer < coarser))
    };
    let wrong: Vec<(f64, bool)> = densities.tried.iter().filter_map(errors).collect();
    [true, false].map(|better| wrong.iter().filter(|one| one.1 == better).map(|one| one.0).collect())
}

/// Numbers one after the other.
fn list(numbers: &[f64]) -> String {
    if numbers.is_empty() { "none".into() } else { numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ") }
}

/// The patch test and Hertz across meshes that do not match.
pub(super) fn non_matching() -> Result<Limit, Error> {
    let densities = Push::of("second / first", &DENSITIES, ORDERS, Across::at)?;
    let patch = largest(densities.all().flat_map(|across| across.patch));
    let fine = densities.tried.iter().filter(|(density, _)| *density >= COARSE);
    let coarser = Push {
        name: densities.name,
        tried: densities.tried.iter().rev().map(|(density, [four, eight])| (*density, [four, eight])).collect(),
    };
    let [four, eight] = [0, 1].map(|k| coarser.onset(|found| found[k].blocks[0].is_off(WRONG)));
    let [of_four, of_eight] = [0, 1].map(|k| sides(&densities, k));
    let rows: Vec<(f64, &Across)> =
        densities.tried.iter().flat_map(|(density, found)| found.iter().map(|across| (*density, across))).collect();
    Ok(Limit {
        pushed: "non-matching meshes",
        range: densities.range("elements of the second body over those of the first"),
        onset: format!(
            "error beyond {}: 4-node {four}; 8-node {eight}; largest error of the patch test {}",
            size(WRONG),
            within(patch, ITERATED)
        ),
        seen: format!("{}; only a finer mesh shows the error", densities.last()[1].blocks[1].seen()),
        instead: format!(
            "8-node cells. Where points on either side are off by more than {}, those on the finer side are less so \
            with 8-node cells at second / first = {}, with 4-node cells at {}; those on the coarser side with 4-node \
            cells at {}. The body named `first` has them",
            size(WRONG),
            list(&of_eight[0]),
            list(&of_four[0]),
            list(&of_four[1])
        ),
        judged: vec![
            Check::error(
                Quantity::at(
                    "largest |p − q| / q of the patch test across meshes that do not match",
                    "all elements, both orders",
                ),
                Reference::analytic("the uniform pressure", 0.0),
                ITERATED,
                "exact but for the iteration: both sides integrate the same pressure",
            )
            .judge(patch),
            Check::error(
                Quantity::at(
                    "difference of the contact forces on both bodies and of their moments",
                    "over the force on the first, and over the force times the stretch",
                ),
                Reference::own("action and reaction", 0.0),
                1e-10,
                "round-off: the weights of the nodes on the other side reproduce constants and the coordinate itself",
            )
            .judge(largest(densities.all().map(|across| across.unbalanced))),
            Check::none(
                Quantity::at(
                    "ratio of elements at which points on the coarser side are the better ones",
                    format!("8-node, error beyond {}", size(WRONG)),
                ),
                "points on a coarse side do not see what the finer one does between them",
            )
            .judge(if of_eight[0].is_empty() { f64::NAN } else { of_eight[1].len() as f64 }),
            against_hertz(
                Quantity::at(
                    "largest error of p₀ and a at points opposite a side up to twice as coarse as their own, or finer",
                    "8-node, node element",
                ),
                worst(fine.map(|(_, [_, eight])| &eight.blocks[0])),
                WRONG,
                "engineering tolerance of the paper's comparison, 8 cells per half-width on the first body",
            ),
        ],
        table: folded(
            "Two blocks whose meshes do not match: largest error of a uniform pressure, and with Hertz's tractions",
            &rows,
            &[
                ("elements, second / first", |(density, _)| number(*density)),
                ("cells", |(_, across)| format!("{}-node", across.nodes)),
                ("patch: line", |(_, across)| within(across.patch[0], ITERATED)),
                ("patch: layer", |(_, across)| within(across.patch[1], ITERATED)),
                ("patch: node", |(_, across)| within(across.patch[2], ITERATED)),
                ("Hertz, node element: p₀", |(_, across)| percent(across.blocks[0].errors().peak)),
                ("a", |(_, across)| percent(across.blocks[0].errors().half_width)),
                ("points on the second: p₀", |(_, across)| percent(across.blocks[1].errors().peak)),
                ("a", |(_, across)| percent(across.blocks[1].errors().half_width)),
            ],
        ),
    })
}
