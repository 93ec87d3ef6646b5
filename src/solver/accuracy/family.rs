//! The same scene on other meshes, coarser ones and the next finer one: what they say tells the mesh's part of a bar
//! (`evidence`).

use rayon::prelude::*;

use crate::accuracy::coarser::{coarser, finer, gentler};
use crate::accuracy::elements::{
    Beneath, Corner, beneath, held_at_corner, is_shallow, loaded_corners, of_second, sizes, spacings_at_vertex,
};
use crate::accuracy::reading::{Reading, of_discrete, recovered};
use crate::measure::{Measures, larger};
use crate::mesh::Order;
use crate::scene::{ContactPair, Profile, Scene};
use crate::solve::run::BALANCED;
use crate::solve::{Discretisation, Displaced, Element, Formulation, Iteration, Permits, Run, Settings};

/// Imbalance of a body up to which a run whose iteration has converged says something, and how much of it a bar has:
/// the stiffness of a thin ring leaves forces no better than 1e-7 to 1e-5, whatever is iterated.
pub(super) const UNBALANCED: (f64, f64) = (1e-4, 10.0);
/// Why a bar is not known where more than a little is out of balance.
pub(super) const LOST: &str =
    "round-off takes part of the forces, in cells that are too long and thin, or too stiff: try --fitted";
/// Tolerance of the runs on coarser meshes.
const TOLERANCE: f64 = 1e-9;
/// The same where cells shrink towards a cusp of the pressure: on an axis of revolution round-off leaves a
/// hundred-thousandth of what the smallest rings carry.
const CUSPED: f64 = 1e-4;
/// Iteration error up to which those tell a bar that end before, as line elements on meshes of some hundred elements.
const NEAR: f64 = 1e-5;
/// Factor on the square of how far an end may be off, over the half-width: 2 tells the error of a half-width, 1/2 that
/// of a peak, since at the end the potential energy is the least; and half of 2 for that of the force, with whose root
/// both grow.
const MISFIT: f64 = 3.0;

/// The coarser meshes of a run.
#[derive(Debug)]
pub struct Family {
    /// What finds the discrete solution of the run's own contact element, without a penalty.
    pub(super) formulation: Formulation,
    pub(super) order: Order,
    /// Mean candidate element of each contact.
    pub(super) sizes: Vec<f64>,
    /// Two mean spacings of the candidates of its second body.
    pub(super) others: Vec<f64>,
    /// Cells made elsewhere below each contact, of both bodies.
    pub(super) beneath: Vec<Vec<Beneath>>,
    /// Ends of the sides that carry a load: body, place, and length of the outermost edge.
    pub(super) corners: Vec<Corner>,
    /// Along which components a body is held where it loses regularity.
    pub(super) held_at_corner: [bool; 2],
    pub(super) cells: usize,
    /// Whether mesh lines lie on the ends of the contacts.
    pub(super) on_ends: bool,
    /// Layers of cells towards those.
    pub(super) layers: usize,
    /// The gap of each contact. Where it is not smooth, errors fall less from order to order; where points tell it, its
    /// curvature may leap.
    pub(super) profiles: Vec<Profile>,
    /// Whether the mesh of a body was made elsewhere.
    pub(super) given: bool,
    /// Whether a body is one element deep below a contact, which no coarser mesh tells from a finer one.
    pub(super) shallow: bool,
    pub(super) coarse: Vec<Other>,
    /// What the mesh of gentler growth says, if it does; none where no body bends nor is clamped.
    pub(super) gentler: Option<Option<Other>>,
    /// What the next finer mesh says, where errors fall from order to order as those of an analytic solution do.
    pub(super) next: Option<Other>,
    /// Relative error that mesh lines may leave, which do not lie on the ends of the contacts.
    pub(super) misfit: f64,
    /// What of a peak at s = 0 lies above what the nodes beside it carry, of each contact \[MPa\].
    pub(super) cusps: Vec<f64>,
    /// Whether each contact begins on the axis of revolution.
    pub(super) circles: Vec<bool>,
    /// Whether cells of a body of each contact smooth its dilatation.
    pub(super) smoothed: Vec<bool>,
}

/// What another mesh says.
#[derive(Debug)]
pub(super) struct Other {
    /// Mean candidate element of each contact.
    pub(super) sizes: Vec<f64>,
    pub(super) cells: usize,
    dofs: usize,
    pub(super) readings: Vec<Reading>,
    /// What is left over of the forces on a body.
    pub(super) imbalance: f64,
}

impl Family {
    /// What coarser meshes say of the numbers that a contact element finds on a mesh, with the settings of a
    /// formulation, and of the displacements that are wanted; without those of the contacts alone.
    pub fn of(discretisation: &Discretisation, formulation: &Formulation, wanted: Option<&[Displaced]>) -> Self {
        Self::permitted(discretisation, formulation, wanted, None, &|_| Ok(()))
    }

    /// The same by meshes that are permitted, and by the next one where that was solved.
    pub(super) fn permitted(
        discretisation: &Discretisation,
        formulation: &Formulation,
        wanted: Option<&[Displaced]>,
        judge: Option<(&Discretisation, &Run)>,
        permits: Permits,
    ) -> Self {
        let formulation = exact(formulation, &discretisation.scene);
        let (scene, resolution) = (&discretisation.scene, discretisation.resolution);
        let on_ends = scene.contacts.iter().any(|pair| !pair.ends.places.is_empty());
        // A mesh too coarse to hold the contact says nothing.
        let said = |(scene, resolution)| {
            let coarse = Discretisation::permitted(scene, resolution, permits).ok()?;
            let run = Run::of(&coarse, &formulation).ok()?;
            said((&coarse, &run), wanted, on_ends)
        };
        let by_next = on_ends && resolution.order >= Order::Quartic && formulation.element == Element::Node;
        let next = match judge {
            Some(judge) => self::said(judge, wanted, on_ends),
            None if by_next => said(finer(scene, resolution)),
            None => None,
        };
        let (gentler, coarse) = rayon::join(
            || gentler(scene, resolution).map(said),
            // Of the contacts alone the next mesh tells all; and of cells of order 4, below which there are 8-node
            // cells only.
            || match (&next, wanted) {
                (Some(_), None) => Vec::new(),
                (Some(_), _) if resolution.order == Order::Quartic => Vec::new(),
                _ => coarser(scene, resolution).into_par_iter().filter_map(said).collect(),
            },
        );
        Self { coarse, gentler, next, ..Self::alone(discretisation, formulation) }
    }

    /// What a finer mesh of those that end with the contact says of the contacts.
    pub(super) fn judged(
        discretisation: &Discretisation,
        formulation: &Formulation,
        finer: (&Discretisation, &Run),
    ) -> Self {
        Self { next: said(finer, None, true), ..Self::alone(discretisation, exact(formulation, &discretisation.scene)) }
    }

    /// The mesh itself, beside no other.
    fn alone(discretisation: &Discretisation, formulation: Formulation) -> Self {
        let scene = &discretisation.scene;
        let contacts = &scene.contacts;
        let on_ends = contacts.iter().any(|pair| !pair.ends.places.is_empty());
        let off = contacts.iter().map(|pair| pair.ends.off).fold(0.0, larger);
        let sizes = sizes(discretisation);
        let order = discretisation.resolution.order;
        let spacings = spacings_at_vertex(discretisation);
        let cusp = |(pair, spacing): (&ContactPair, f64)| scene.modulus_of(pair) * pair.profile.cusp(spacing);
        let cusps = contacts.iter().zip(spacings).map(cusp).collect();
        let corners = loaded_corners(discretisation);
        Self {
            formulation,
            order,
            sizes,
            others: of_second(discretisation),
            beneath: contacts
                .iter()
                .map(|pair| pair.bodies().flat_map(|body| beneath(discretisation, pair, body)).collect())
                .collect(),
            held_at_corner: held_at_corner(discretisation, &corners),
            corners,
            cells: discretisation.mesh.cells(),
            on_ends,
            layers: contacts.iter().map(|pair| pair.ends.layers).min().unwrap_or(0),
            profiles: contacts.iter().map(|pair| pair.profile.clone()).collect(),
            given: scene.bodies.iter().any(|body| body.shape.has_given_mesh()),
            shallow: !on_ends && is_shallow(discretisation),
            coarse: Vec::new(),
            gentler: None,
            next: None,
            misfit: MISFIT * off * off,
            cusps,
            circles: (0..contacts.len()).map(|contact| scene.is_around_axis(contact)).collect(),
            smoothed: contacts.iter().map(|pair| pair.bodies().any(|body| discretisation.is_smoothed(body))).collect(),
        }
    }

    /// Whether a run on the same mesh has found what its iteration ends at.
    pub(super) fn is_found(&self, run: &Run) -> bool {
        is_found(run, self.on_ends)
    }

    /// How many of them tell something.
    pub(super) fn meshes(&self) -> usize {
        if self.shallow { 0 } else { self.coarse.len() + usize::from(self.next.is_some()) }
    }

    /// Degrees of freedom of all meshes that tell.
    pub(super) fn dofs(&self) -> usize {
        self.coarse.iter().chain(self.gentler.iter().flatten()).chain(&self.next).map(|one| one.dofs).sum()
    }
}

/// The measures of a contact wherever the iteration ended.
pub(super) fn discrete_of(run: &Run, contact: usize) -> &Measures {
    match &run.contacts[contact].exact {
        Some([_, discrete]) => discrete,
        None => &run.contacts[contact].measures,
    }
}

/// Whether a run has found what its iteration ends at: it has converged or, where round-off ends it before, is as near
/// to the solution of its active set as bars need. On meshes fitted to the ends of a contact round-off may leave more
/// of the balance of a body than a solve accepts; others leave more in a body that is as thin than coarser ones tell.
fn is_found(run: &Run, on_ends: bool) -> bool {
    let is_near = || run.iteration_error() <= NEAR && run.imbalance() <= BALANCED;
    if on_ends { run.is_found(UNBALANCED.0) } else { run.solution.converged() || is_near() }
}

/// What of a body's balance round-off takes: what the iteration leaves is its own part.
pub(super) fn lost_balance(run: &Run) -> f64 {
    larger(run.imbalance() - run.iteration_error(), 0.0)
}

/// The formulation that finds the discrete solution of a contact element on meshes of a scene, with the settings of
/// another one.
fn exact(formulation: &Formulation, scene: &Scene) -> Formulation {
    let Formulation { element, layer_thickness, settings, .. } = *formulation;
    let has_cusp = scene.contacts.iter().any(|pair| pair.power_at_cusp().is_some());
    let tolerance = if has_cusp { CUSPED } else { TOLERANCE.min(settings.tolerance) };
    let settings = Settings { tolerance, ..Settings::default() };
    Formulation { layer_thickness, settings, ..Formulation::new(element, Iteration::Kinematic) }
}

/// What a run on another mesh says; nothing where it was not found.
fn said((mesh, run): (&Discretisation, &Run), wanted: Option<&[Displaced]>, on_ends: bool) -> Option<Other> {
    if !is_found(run, on_ends) {
        return None;
    }
    let mut readings = of_discrete(mesh, run, 1);
    if let Some(wanted) = wanted {
        readings.extend(recovered(mesh, run, wanted).ok()?.0);
    }
    let (cells, dofs, imbalance) = (mesh.mesh.cells(), run.dofs, run.imbalance());
    Some(Other { sizes: sizes(mesh), cells, dofs, readings, imbalance })
}
