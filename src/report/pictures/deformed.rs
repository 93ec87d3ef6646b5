//! The deformed bodies of one run with their von Mises stress, the contact enlarged where it is small.

use crate::drawing::{ColourMap, Detail, Field, Window};
use crate::error::Error;
use crate::markdown::significant;
use crate::solve::{Discretisation, Run, shapes};
use crate::study::drawn::marks;

/// Largest displacement in the drawing, over the size of the bodies.
const SHOWN: f64 = 0.05;
/// A contact shorter than this part of the bodies is enlarged.
const SMALL: f64 = 0.15;
/// Half of the side of the enlarged square, over the length of the contact.
const AROUND: f64 = 1.8;
/// Margin around the bodies in the detail, over the side of the square.
const MARGIN: f64 = 0.02;
/// An overlap drawn larger than this part of the bodies is explained.
const VISIBLE: f64 = 0.003;
/// Part of the nodes whose stresses the colours tell apart, where a few others lie far above.
const TOLD_APART: f64 = 0.99;
/// What lies far above: more than this times the stress of those nodes.
const FAR: f64 = 2.0;

/// The bodies under the last iteration's displacements; none where these are not finite.
pub fn field(discretisation: &Discretisation, run: &Run) -> Result<Option<Field>, Error> {
    let fields = discretisation.recover_under(run.share(), &run.solution)?;
    let mesh = &discretisation.mesh;
    let values = discretisation.von_mises(&fields);
    if !fields.displacement.as_flattened().iter().chain(&values).all(|number| number.is_finite()) {
        return Ok(None);
    }
    let pairs = |list: &[[f64; 2]]| list.iter().map(|&[x, y]| (x, y)).collect();
    let largest = fields.displacement.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let size = side(bounds(&mesh.points));
    let magnification = round_factor(SHOWN * size / largest);
    let (range, above) = range(&values);
    let overlap = overlap(discretisation, run, magnification, VISIBLE * size);
    Ok(Some(Field {
        title: format!("Deformed shape, displacements ×{magnification}, and von Mises stress"),
        quantity: "σ_v [MPa]".into(),
        points: pairs(&mesh.points),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        shapes,
        values,
        displacements: pairs(&fields.displacement),
        magnification,
        map: ColourMap::Sequential,
        range,
        details: (0..run.contacts.len())
            .filter_map(|contact| detail(discretisation, run, contact, &fields.displacement, magnification))
            .collect(),
        marks: marks(discretisation)?,
        notes: overlap.into_iter().chain(above).collect(),
    }))
}

/// The number 1, 2 or 5 times a power of ten that is nearest in ratio; 1 where there is nothing to magnify.
pub fn round_factor(factor: f64) -> f64 {
    if !(factor.is_finite() && factor > 0.0) {
        return 1.0;
    }
    let decade = factor.log10().floor() as i32;
    // From text: `2e-3` is then the shortest number that is written so.
    let round = |digit: u8, decade: i32| format!("{digit}e{decade}").parse().unwrap_or(f64::NAN);
    let near = [round(1, decade), round(2, decade), round(5, decade), round(1, decade + 1)];
    let off = |number: &f64| (number / factor).ln().abs();
    near.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(1.0)
}

/// Ends of the colour bar where single nodes, as under a point force, lie far above all others, and a note that says
/// so.
fn range(values: &[f64]) -> (Option<(f64, f64)>, Option<String>) {
    let mut ascending = values.to_vec();
    ascending.sort_by(f64::total_cmp);
    let at = |part: f64| ascending[(part * (ascending.len() - 1) as f64) as usize];
    let (low, high, largest) = (at(0.0), at(TOLD_APART), at(1.0));
    if largest <= FAR * high {
        return (None, None);
    }
    let note =
        format!("A few stresses above the colour bar, up to {} MPa, have its last colour.", significant(largest, 3));
    (Some((low, high)), Some(note))
}

/// A square around a contact as it is truly displaced, cut at the bodies; none where the contact is not small.
fn detail(
    discretisation: &Discretisation,
    run: &Run,
    contact: usize,
    displacement: &[[f64; 2]],
    magnification: f64,
) -> Option<Detail> {
    let (pair, mesh) = (&discretisation.scene.contacts[contact], &discretisation.mesh);
    let measures = &run.contacts[contact].measures;
    let [begin, edge] = [measures.begin(), measures.edge()];
    let reach = 0.5 * (edge - begin) * pair.path.metric();
    if !(reach > 0.0 && reach < SMALL * side(bounds(&mesh.points))) {
        return None;
    }
    let part = &mesh.bodies[pair.first];
    let own = &part.candidates[part.candidates_of(contact)];
    let closed = || own.iter().filter(|at| at.coordinate >= begin && at.coordinate <= edge);
    let moved = |node: usize| [0, 1].map(|k| mesh.points[node][k] + displacement[node][k]);
    let middle = bounds(&closed().map(|at| moved(at.node)).collect::<Vec<_>>()).map(|[low, high]| 0.5 * (low + high));
    let bodies = bounds(&(0..mesh.points.len()).map(moved).collect::<Vec<_>>());
    let half = AROUND * reach;
    let ends = [0, 1].map(|k| {
        let [low, high] = bodies[k];
        let margin = 2.0 * MARGIN * half;
        ((middle[k] - half).max(low - margin), (middle[k] + half).min(high + margin))
    });
    let count = closed().count() as f64;
    let mean = [0, 1].map(|k| closed().map(|at| displacement[at.node][k]).sum::<f64>() / count);
    let further = |k: usize| ((magnification - 1.0) * mean[k], ends[k]);
    let [x, y] = [0, 1].map(further).map(|(by, (low, high))| (low + by, high + by));
    let name = if run.contacts.len() > 1 { pair.name.clone() } else { String::new() };
    Some(Detail { name, window: Window { x: ends[0], y: ends[1] }, magnification: 1.0, marked: Window { x, y } })
}

/// What closed gaps look like where displacements are magnified, if it can be seen.
fn overlap(discretisation: &Discretisation, run: &Run, magnification: f64, visible: f64) -> Option<String> {
    let floor = run.formulation.settings.tolerance * discretisation.scene.reference.pressure;
    let gaps = discretisation.interfaces.iter().flat_map(|own| {
        let closed = run.solution.points_of(own.contact).iter().filter(move |point| point.pressure > floor);
        // That of the node beside it: of bodies whose gap is drawn no profile has it.
        closed.filter_map(|point| {
            let all = own.nodes.iter().map(|node| ((node.coordinate - point.position).abs(), node.gap));
            all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, gap)| gap)
        })
    });
    let (low, high) = gaps.fold((0.0_f64, 0.0_f64), |(low, high), gap| (low.min(gap), high.max(gap)));
    let shown = |gap: f64| gap * magnification > visible;
    match () {
        _ if shown(-low) => Some("Where displacements are magnified, interference looks like a gap.".into()),
        _ if shown(high) => Some("Where displacements are magnified, closed gaps look like overlap.".into()),
        _ => None,
    }
}

/// Least and largest x and y.
fn bounds(points: &[[f64; 2]]) -> [[f64; 2]; 2] {
    [0, 1].map(|k| {
        let of = points.iter().map(|point| point[k]);
        of.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    })
}

fn side(bounds: [[f64; 2]; 2]) -> f64 {
    bounds.into_iter().map(|[low, high]| high - low).fold(0.0, f64::max)
}
