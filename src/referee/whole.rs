//! What displacements on the whole mesh tell: whether their stresses are in equilibrium with loads and pressures, their
//! strain energy, and the displacements, reactions, approaches and shears that a scene file declares.

use std::ops::Range;

use crate::case::{self, Against, Check, Judged, Reference, Relation, Verdict};
use crate::contact::interface::ContactNode;
use crate::elasticity::{loads, reactions};
use crate::error::Error;
use crate::measure::{Measures, Quantity, larger};
use crate::mesh::Candidate;
use crate::oracle::ReferenceKind;
use crate::referee::Ruled;
use crate::referee::bench::{Bench, along};
use crate::referee::contact_laws;
use crate::referee::declared::{GRID, of_another_mesh};
use crate::referee::field::Field;
use crate::referee::profile::Profile;
use crate::referee::truth::{Exported, Known, OURS, Truth};
use crate::scene::{Load, Place, Scene};
use crate::solve::{Discretisation, Run};

/// Part of the candidate stretch by which a point may lie off the symmetry line for the digits of its file.
const SAME: f64 = 1e-9;

/// What gaps of displacements are told by.
const OVERLAP: &str =
    "gap or overlap of the displacements under pressure, weighted by force, over the approach that the contact makes";
/// What strains are told by, what those of coarse meshes differ by, and the energy over that of all bodies that are
/// looked at that tells something.
const STRAINS: &str = "departure of the strains from ours, apart from a factor";
const ALIKE: f64 = 0.02;
const LEAST: f64 = 1e-3;

/// What supports are told by.
const SUPPORTS: &str = "departure of the supports from what they prescribe, over the largest displacement";

/// What cannot be judged without displacements.
pub fn missing() -> [String; 2] {
    ["equilibrium of the stresses, and strain energy".into(), GRID.into()]
}

/// A field with all that is needed to judge it.
struct Whole<'a> {
    truth: &'a Truth,
    /// The case on the mesh that it is exported on.
    own: &'a Discretisation,
    /// Displacements of its nodes.
    displacement: Vec<[f64; 2]>,
    /// Internal forces of its nodes.
    internal: Vec<[f64; 2]>,
    tolerance: f64,
}

/// Judges a field: what belongs to no contact goes to the first of the profiles, of which there is one. Whether its
/// strain energy is that of the scene.
pub fn judge(
    truth: &Truth,
    field: &Field,
    profiles: &[Profile],
    ruled: &mut [Ruled],
    tolerance: f64,
) -> Result<bool, Error> {
    let Exported { discretisation: own, displacement: ours, energies } = exported(truth)?;
    let displacement = match field.at_nodes(own) {
        Ok(displacement) => displacement,
        Err(why) => {
            let [what, how] = missing();
            ruled[0].missing.push([what, format!("{how}: {why}")]);
            return Ok(false);
        }
    };
    let internal = internal(own, &displacement)?;
    let whole = Whole { truth, own, displacement, internal, tolerance };
    ruled[0].judged.extend(whole.supports()?);
    for (profile, ruled) in profiles.iter().zip(&mut *ruled) {
        ruled.judged.extend(whole.declared(profile, ruled.contact, &mut ruled.missing)?);
    }
    for (profile, ruled) in profiles.iter().zip(&mut *ruled) {
        ruled.judged.extend(whole.overlap(profile));
    }
    let first = &mut ruled[0];
    let (told, untold): (Vec<usize>, Vec<usize>) =
        (0..own.scene.bodies.len()).partition(|body| is_told(&own.scene, *body, profiles));
    first.judged.extend(whole.equilibrium(&told, profiles)?);
    first.missing.extend(untold.into_iter().map(|body| {
        let what = format!("equilibrium of the stresses of `{}`", own.scene.bodies[body].name);
        [what, "the pressures of every contact of it".into()]
    }));
    let bodies = 0..own.scene.bodies.len();
    let sound: Vec<usize> = bodies.clone().filter(|&body| lost(own, body).is_none()).collect();
    first.missing.extend(bodies.filter_map(|body| {
        let of = if sound.is_empty() { String::new() } else { format!(" of `{}`", own.scene.bodies[body].name) };
        lost(own, body).map(|why| [format!("strain energy of the displacements{of}"), format!("nothing: {why}")])
    }));
    first.missing.dedup();
    if sound.is_empty() {
        return Ok(false);
    }
    let found = [whole.energy(energies, &sound), whole.strains(ours, (energies, &sound))?];
    let is_of_scene = found.iter().all(|judged| judged.verdict == Verdict::Pass);
    first.judged.extend(found);
    Ok(is_of_scene)
}

/// Whether the pressures of all contacts of a body were handed in.
fn is_told(scene: &Scene, body: usize, profiles: &[Profile]) -> bool {
    let mut own = (0..scene.contacts.len()).filter(|&contact| scene.contacts[contact].bodies().any(|one| one == body));
    own.all(|contact| profiles.iter().any(|profile| profile.contact == contact))
}

/// Part of their work that stresses may miss where a force acts at a point, whose displacement grows with every mesh.
const AT_POINT: f64 = 0.05;
/// Poisson's ratio beyond which it is: stresses of 4-node cells by 2 % at 0.49, all by half at 0.4999.
const INCOMPRESSIBLE: f64 = 0.45;

/// Why the energy of a body in a right field is not that of the scene once its displacements are brought to another
/// mesh, if it is not.
fn lost(own: &Discretisation, body: usize) -> Option<&'static str> {
    match () {
        _ if has_force(own, body) => Some("beside a force at a point it has no limit, and grows with every mesh"),
        _ if is_incompressible(own, body) => Some(
            "a body is nearly incompressible, and its pressure is lost where displacements are brought to another mesh",
        ),
        _ => None,
    }
}

/// Whether a force acts at a point of a body.
fn has_force(own: &Discretisation, body: usize) -> bool {
    own.scene.bodies[body].loads.iter().any(|load| matches!(load, Load::Force { .. }))
}

/// Whether the pressure inside a body is lost where displacements are brought to another mesh.
fn is_incompressible(own: &Discretisation, body: usize) -> bool {
    own.is_smoothed(body) && own.scene.bodies[body].material.poisson > INCOMPRESSIBLE
}

/// The case on the mesh that it is exported on: solved once for all fields that are judged.
fn exported(truth: &Truth) -> Result<&Exported, Error> {
    if let Some(known) = truth.exported.get() {
        return Ok(known);
    }
    let (meshed, run) = truth.case.solve()?;
    let moved = |on: &Discretisation, run: &Run| on.displacement_under(run.share(), &run.solution);
    let energy = |on: &Discretisation, moved: &[[f64; 2]]| {
        let forces = internal(on, moved)?;
        let of = |nodes: &Range<usize>| work(&forces[nodes.clone()], &moved[nodes.clone()]);
        Ok::<_, Error>(on.mesh.bodies.iter().map(|body| of(&body.nodes)).collect::<Vec<f64>>())
    };
    let [fine, displacement] = [moved(&truth.discretisation, &truth.run), moved(&meshed.discretisation, &run)];
    let fine = energy(&truth.discretisation, &fine)?.into_iter();
    let energies = fine.zip(energy(&meshed.discretisation, &displacement)?).map(|(fine, own)| [fine, own]).collect();
    Ok(truth.exported.get_or_init(|| Exported { discretisation: meshed.discretisation, displacement, energies }))
}

/// Internal forces of all nodes.
fn internal(own: &Discretisation, displacement: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, Error> {
    let of = |body| reactions::internal_forces(&own.scene, &own.mesh, body, displacement, &|_| true);
    let bodies = (0..own.scene.bodies.len()).map(of).collect::<Result<Vec<_>, Error>>()?;
    Ok(bodies.concat())
}

/// `½ f·u` \[N mm\]: of the displacements that the forces are of their strain energy.
fn work(forces: &[[f64; 2]], displacement: &[[f64; 2]]) -> f64 {
    let pairs = forces.iter().zip(displacement);
    0.5 * pairs.map(|(force, moved)| force[0] * moved[0] + force[1] * moved[1]).sum::<f64>()
}

/// Linear motions of a body: of which component, in proportion to which coordinate.
const MOTIONS: [(&str, [usize; 2]); 4] = [
    ("stresses against loads and pressures: stretched along x", [0, 0]),
    ("stresses against loads and pressures: sheared along x", [0, 1]),
    ("stresses against loads and pressures: sheared along y", [1, 0]),
    ("stresses against loads and pressures: stretched along y", [1, 1]),
];
/// One way stretched, the other squeezed.
const SQUEEZED: &str = "stresses against loads and pressures: stretched one way, squeezed the other";

/// What a motion of a body works: the motion, what the stresses work less what loads and pressures do, and what every
/// load and pressure works, all taken as positive.
type Work = ((&'static str, [usize; 2]), f64, f64);

impl Whole<'_> {
    /// Strain energy of some bodies against that of our fine answer, which may be off by what it is apart from that on
    /// the exported mesh.
    fn energy(&self, energies: &[[f64; 2]], bodies: &[usize]) -> Judged {
        let [fine, coarse] = [0, 1].map(|which| bodies.iter().map(|&body| energies[body][which]).sum::<f64>());
        let bar = (fine - coarse).abs();
        let reference = Reference { name: OURS.into(), kind: ReferenceKind::CrossCode, value: fine, uncertainty: None };
        let allowed = self.tolerance + bar / fine.abs();
        let because = "the tolerance, and what the energy still changes with our mesh";
        let check = Check::near(
            case::Quantity::at("strain energy of the displacements [N mm]", ""),
            reference,
            allowed,
            because,
        );
        let of = |nodes: Range<usize>| work(&self.internal[nodes.clone()], &self.displacement[nodes]);
        check.judge(bodies.iter().map(|&body| of(self.own.mesh.bodies[body].nodes.clone())).sum())
    }

    /// `1 − a(u, u')/√(a(u, u) a(u', u'))` of the displacements and ours on the exported mesh, by the body where it is
    /// most: 0 where strains are alike but for a factor, 2 where they have the other sign, which no energy shows. Not
    /// of bodies that hardly deform.
    fn strains(&self, ours: &[[f64; 2]], (energies, bodies): (&[[f64; 2]], &[usize])) -> Result<Judged, Error> {
        let forces = internal(self.own, ours)?;
        let least = LEAST * bodies.iter().map(|&body| energies[body][1]).sum::<f64>();
        let apart = |body: usize| {
            let nodes = self.own.mesh.bodies[body].nodes.clone();
            let [own, theirs] = [(&forces[..], ours), (&self.internal[..], &self.displacement[..])]
                .map(|(forces, moved)| work(&forces[nodes.clone()], &moved[nodes.clone()]));
            let both = work(&self.internal[nodes.clone()], &ours[nodes]);
            // A body that is not deformed is as far off as can be.
            let apart = if theirs > 0.0 { 1.0 - both / (own * theirs).sqrt() } else { f64::INFINITY };
            (own > least).then_some((if apart.is_nan() { f64::INFINITY } else { apart }, body))
        };
        let worst = bodies.iter().copied().filter_map(apart).max_by(|a, b| a.0.total_cmp(&b.0));
        let (apart, body) = worst.unwrap_or((f64::NAN, 0));
        let reference = Reference { name: OURS.into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
        let quantity = case::Quantity::at(STRAINS, self.own.scene.bodies[body].name.clone());
        let because = "the tolerance, and what strains of two coarse meshes differ by";
        Ok(Check::error(quantity, reference, larger(ALIKE, self.tolerance), because).judge(apart))
    }

    /// The gap that the displacements leave under pressure, weighted by force, over the approach that the contact
    /// makes, or its moment over the reach of the pressure, where an overlap on one side makes up for a gap on the
    /// other: of every node of our mesh its initial gap less the normal displacements of both sides.
    fn overlap(&self, profile: &Profile) -> Option<Judged> {
        let Discretisation { mesh, condensed, interfaces, .. } = self.own;
        let interface = interfaces.get(profile.contact)?;
        let outwards = |dof: usize| {
            let body = condensed.offsets.partition_point(|begin| *begin <= dof) - 1;
            let Candidate { node, normal, .. } = mesh.bodies[body].candidates[dof - condensed.offsets[body]];
            normal[0] * self.displacement[node][0] + normal[1] * self.displacement[node][1]
        };
        let left = |node: &ContactNode| {
            (node.coordinate, node.gap - node.row().map(|(dof, weight)| weight * outwards(dof)).sum::<f64>())
        };
        let gaps: Vec<(f64, f64)> = interface.nodes.iter().map(left).collect();
        let place = |s: f64| if interface.pair.path.has_both_sides() { s } else { s.abs() };
        let pressed = profile.points.iter().map(|point| (place(point.position), point.weight * point.pressure));
        let pressed: Vec<(f64, f64)> = pressed.filter(|(_, force)| force.abs() > 0.0).collect();
        let force: f64 = pressed.iter().map(|(_, force)| force).sum();
        let centre = pressed.iter().map(|(s, force)| force * s).sum::<f64>() / force;
        let reach = pressed.iter().map(|(s, _)| (s - centre).abs()).fold(0.0, larger);
        let left = |arm: &dyn Fn(f64) -> f64| {
            pressed.iter().map(|&(s, force)| force * arm(s) * along(&gaps, s)).sum::<f64>() / force
        };
        let gap = larger(left(&|_| 1.0).abs(), left(&|s| (s - centre) / reach.max(f64::MIN_POSITIVE)).abs());
        let touch = Reference::own("bodies touch where they press", 0.0);
        let because = "the tolerance; an overlap of this part costs about as much of the pressure";
        let check = Check::error(OVERLAP, touch, self.tolerance, because);
        Some(check.judge(gap / contact_laws::approach(self.truth, profile)))
    }

    /// Whether supports move as they prescribe: the largest departure of a node that one holds, over the largest
    /// displacement.
    fn supports(&self) -> Result<Option<Judged>, Error> {
        let Discretisation { scene, mesh, .. } = self.own;
        let mut worst = None;
        for (index, body) in scene.bodies.iter().enumerate() {
            for support in &body.supports {
                let nodes = mesh.nodes_at(scene, index, &support.at)?.into_iter();
                let off = nodes.map(|node| (self.displacement[node][support.component.index()] - support.value).abs());
                worst = off.chain(worst).reduce(larger);
            }
        }
        let largest = self.displacement.iter().map(|u| u[0].hypot(u[1])).fold(0.0, larger);
        let because = "the tolerance: supports hold what the scene prescribes";
        let check = Check::error(SUPPORTS, Reference::own("the supports", 0.0), self.tolerance, because);
        Ok(worst.map(|off| check.judge(off / largest)))
    }

    /// Virtual work of the stresses in every body against that of loads and pressures on it, for linear motions under
    /// which no support works: of each motion the body that is most off, over the largest work that it does and what it
    /// may miss of that.
    fn equilibrium(&self, bodies: &[usize], profiles: &[Profile]) -> Result<Vec<Judged>, Error> {
        let mut worst: Vec<(&'static str, usize, f64)> = Vec::new();
        for &body in bodies {
            let works = self.works(body, profiles)?;
            let scale = works.iter().map(|(.., size)| *size).fold(self.least_work(body, profiles), larger);
            for (name, left) in self.left(body, &works) {
                let left = left.abs() / scale / self.of_works(body).0;
                match worst.iter_mut().find(|(other, ..)| *other == name) {
                    Some((.., most)) if left <= *most || most.is_nan() => {}
                    Some(other) => *other = (name, body, left),
                    None => worst.push((name, body, left)),
                }
            }
        }
        let judged = |(name, body, over): (&'static str, usize, f64)| {
            let (tolerance, because) = self.of_works(body);
            let quantity = case::Quantity::at(name, self.own.scene.bodies[body].name.clone());
            Check::error(quantity, Reference::own("virtual work", 0.0), tolerance, because).judge(over * tolerance)
        };
        Ok(worst.into_iter().map(judged).collect())
    }

    /// Part of the works of a body that stresses may miss, and why.
    fn of_works(&self, body: usize) -> (f64, &'static str) {
        match has_force(self.own, body) {
            true => {
                (self.tolerance.max(AT_POINT), "what the displacement of a force at a point misses on another mesh")
            }
            false => {
                (self.tolerance, "the tolerance: virtual work of linear motions is exact for elements of any order")
            }
        }
    }

    /// What works leave, by motion; of a nearly incompressible body under those that change no volume, since what its
    /// mean stress works is lost.
    fn left(&self, body: usize, works: &[Work]) -> Vec<(&'static str, f64)> {
        let named = |((name, _), left, _): &Work| (*name, *left);
        if !is_incompressible(self.own, body) {
            return works.iter().map(named).collect();
        }
        let of = |k: usize| works.iter().find(|((_, motion), ..)| *motion == [k, k]).map(|(_, left, _)| *left);
        // A ring that grows stretches both ways.
        let squeezed = match self.own.scene.plane.radial() {
            Some(radial) => of(radial).zip(of(1 - radial)).map(|(radial, axial)| radial - 2.0 * axial),
            None => of(0).zip(of(1)).map(|(x, y)| x - y),
        };
        let sheared = works.iter().filter(|((_, motion), ..)| motion[0] != motion[1]).map(named);
        sheared.chain(squeezed.map(|left| (SQUEEZED, left))).collect()
    }

    /// The works of a body under linear motions. Bodies of revolution move along x as `u_r ∝ r` alone: all else tears
    /// them at the axis, or has a hoop strain that no polynomial is.
    fn works(&self, body: usize, profiles: &[Profile]) -> Result<Vec<Work>, Error> {
        let (points, nodes) = (&self.own.mesh.points, &self.own.mesh.bodies[body].nodes);
        let mut works = Vec::new();
        for (name, [component, along]) in MOTIONS {
            let is_radial = self.own.scene.plane.radial() == Some(component);
            let Some(from) = self.at_rest(body, component, along)? else { continue };
            if is_radial && (along != component || from.abs() > 0.0) {
                continue;
            }
            let motion = |point: [f64; 2]| point[along] - from;
            let inner: f64 = nodes.clone().map(|node| self.internal[node][component] * motion(points[node])).sum();
            let outer = self.outer(body, component, &motion, profiles)?;
            let size = outer.iter().map(|term| term.abs()).sum();
            works.push(((name, [component, along]), inner - outer.iter().sum::<f64>(), size));
        }
        Ok(works)
    }

    /// A tenth of the work of all pressures along the size of a body: less than this is no scale to judge by.
    fn least_work(&self, body: usize, profiles: &[Profile]) -> f64 {
        let points = profiles.iter().flat_map(|profile| &profile.points);
        let force: f64 = points.map(|point| (point.weight * point.pressure).abs()).sum();
        let span = |axis: usize| {
            let places = || self.own.mesh.bodies[body].nodes.clone().map(|node| self.own.mesh.points[node][axis]);
            places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
        };
        0.1 * force * span(0).max(span(1))
    }

    /// Where a linear motion of a component of a body begins, such that supports and rigid faces are at rest, or move
    /// as one; none where they are not.
    fn at_rest(&self, index: usize, component: usize, along: usize) -> Result<Option<f64>, Error> {
        let Discretisation { scene, mesh, .. } = self.own;
        let size = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let (mut held, mut flat) = (Vec::new(), true);
        let all: Vec<f64> = mesh.points.iter().map(|point| point[along]).collect();
        let same = 1e-9 * size(&all);
        let body = &scene.bodies[index];
        for support in body.supports.iter().filter(|support| support.component.index() == component) {
            held.extend(mesh.nodes_at(scene, index, &support.at)?.into_iter().map(|node| mesh.points[node][along]));
        }
        for load in &body.loads {
            let Load::RigidFace { boundary, component: own, .. } = load else { continue };
            let nodes = mesh.nodes_at(scene, index, &Place::Boundary(boundary.clone()))?;
            let first = mesh.points[nodes[0]][along];
            flat &=
                own.index() != component || nodes.iter().all(|&node| (mesh.points[node][along] - first).abs() <= same);
        }
        let from = held.first().copied().unwrap_or(0.0);
        Ok(Some(from).filter(|from| flat && held.iter().all(|x| (x - from).abs() <= same)))
    }

    /// Work of every load and pressure on a body.
    fn outer(
        &self,
        index: usize,
        component: usize,
        motion: &dyn Fn([f64; 2]) -> f64,
        profiles: &[Profile],
    ) -> Result<Vec<f64>, Error> {
        let Discretisation { scene, mesh, interfaces, .. } = self.own;
        let mut terms = Vec::new();
        let forces = loads::at_nodes(scene, mesh, index)?.into_iter().zip(mesh.bodies[index].nodes.clone());
        terms.extend(forces.map(|(force, node)| force[component] * motion(mesh.points[node])));
        for load in &scene.bodies[index].loads {
            let Load::RigidFace { boundary, component: own, force } = load else { continue };
            let nodes = mesh.nodes_at(scene, index, &Place::Boundary(boundary.clone()))?;
            let works = own.index() == component;
            terms.extend(works.then(|| force * motion(mesh.points[nodes[0]])));
        }
        for profile in profiles {
            let Some(interface) = interfaces.get(profile.contact) else { continue };
            let of = |number: &dyn Fn(&ContactNode) -> f64| -> Vec<(f64, f64)> {
                interface.nodes.iter().map(|node| (node.coordinate, number(node))).collect()
            };
            let places = [0, 1].map(|axis| of(&|node| node.point[axis]));
            let normals = [0, 1].map(|axis| of(&|node| node.normal[axis]));
            let gaps = of(&|node| node.gap);
            // Of a whole model of a half scene the half that is ours; what lies on the line belongs to both.
            let is_half = profile.across && !interface.pair.path.has_both_sides();
            let line = SAME * interface.pair.stretch;
            for point in profile.points.iter().filter(|point| !is_half || point.position >= 0.0 - line) {
                let [at, n] = [&places, &normals].map(|pair| pair.each_ref().map(|known| along(known, point.position)));
                let gap = along(&gaps, point.position);
                let share = if is_half && point.position <= line { 0.5 } else { 1.0 };
                let force = share * point.weight * point.pressure;
                // Nothing presses where there is no other side.
                if force.abs() <= 0.0 {
                    continue;
                }
                let opposite = [0, 1].map(|axis| at[axis] + gap * n[axis]);
                terms.extend((interface.pair.first == index).then(|| 0.0 - force * n[component] * motion(at)));
                terms.extend((interface.pair.second == Some(index)).then(|| force * n[component] * motion(opposite)));
            }
        }
        Ok(terms)
    }

    /// Checks that a scene file declares on displacements.
    fn declared(
        &self,
        profile: &Profile,
        contact: usize,
        missing: &mut Vec<[String; 2]>,
    ) -> Result<Vec<Judged>, Error> {
        let measures = &Measures::of(&profile.scene, contact, profile.part());
        let bench = Bench { truth: self.truth, profile, measures, tolerance: self.tolerance };
        let mut judged = Vec::new();
        for check in self.truth.case.checks.iter().filter(|check| check.contact == contact) {
            let Against::Value(reference) = &check.against else { continue };
            let value = match check.quantity.number() {
                Some(Quantity::Reaction { body, support }) => Some(self.reaction(*body, *support)?),
                Some(number) => self.own.of_displacement(&self.displacement, measures, contact, number)?,
                None => None,
            };
            let Some(value) = value else { continue };
            missing.retain(|[what, _]| *what != check.quantity.to_string());
            let with_model = Check { tolerance: check.tolerance + check.model, ..check.clone() };
            let check = of_another_mesh(&with_model, self.tolerance * self.scale(check));
            let known = Known { reference: reference.clone(), bar: 0.0 };
            judged.push(bench.ruled(check, value, known));
        }
        Ok(judged)
    }

    /// What the tolerance of a check is relative to: where the reference is 0, in its unit the largest displacement, or
    /// the largest force inside.
    fn scale(&self, check: &Check) -> f64 {
        if check.relation != Relation::NearAbsolutely {
            return 1.0;
        }
        let is_force = matches!(check.quantity.number(), Some(Quantity::Reaction { .. }));
        let all = if is_force { &self.internal } else { &self.displacement };
        check.quantity.factor() * all.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, larger)
    }

    /// Force of a support: what the stresses at its nodes leave of their loads.
    fn reaction(&self, body: usize, support: usize) -> Result<f64, Error> {
        let Discretisation { scene, mesh, .. } = self.own;
        let Some(support) = scene.bodies[body].supports.get(support) else { return Ok(f64::NAN) };
        let (axis, first) = (support.component.index(), mesh.bodies[body].nodes.start);
        let loads = loads::at_nodes(scene, mesh, body)?;
        let nodes = mesh.nodes_at(scene, body, &support.at)?;
        Ok(nodes.into_iter().map(|node| self.internal[node][axis] - loads[node - first][axis]).sum())
    }
}
