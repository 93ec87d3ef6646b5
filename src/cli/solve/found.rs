//! What `solve` is asked, and what it found.

use schemars::JsonSchema;
use serde::Serialize;

use crate::accuracy::{self, Barred, Bars};
use crate::case::solved::met;
use crate::case::{Case, Judged, notes, plausible};
use crate::cli::solve::stages::Stages;
use crate::clock::{Clock, Stage};
use crate::error::Error;
use crate::scene::Place;
use crate::solve::{Discretisation, Fitted, Formulation, Reaction, Run, VonMises};

/// What chooses a mesh.
pub enum Mesh {
    /// The options, or the case.
    Given,
    /// The ends of the contact.
    Fitted(Fitted),
    /// An accuracy.
    Accurate(accuracy::Asked),
}

/// What a solve found, as it is told.
pub struct Found {
    /// Scene and oracle, on the mesh that was chosen.
    pub problem: Case,
    /// The bodies on that mesh.
    pub discretisation: Discretisation,
    /// The run.
    pub run: Run,
    /// What of its contacts is hardly meant.
    pub doubts: Vec<Vec<String>>,
    /// Whether neither an accuracy nor the ends of the contact chose the mesh.
    pub is_mesh_given: bool,
    /// What its supports exert.
    pub reactions: Vec<ReactionReading>,
    /// Displacement of every node \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// The largest von Mises stress of every body.
    pub stresses: Vec<VonMises>,
    /// How far each number may be from the truth; none where that was not asked for.
    pub bars: Option<Bars>,
    /// The file's own checks, and that of the accuracy asked for.
    pub checks: Vec<Judged>,
    /// The accuracy that was asked for, and what came of it.
    pub accurate: Option<(accuracy::Asked, accuracy::Answer)>,
}

impl Found {
    /// Solves a case on a mesh, with error bars where they are wanted; tells of every stage as it begins.
    pub fn of(
        (mut problem, formulation, mesh): (Case, Formulation, Mesh),
        with_bars: bool,
        stages: &Stages,
    ) -> Result<Self, Error> {
        let is_mesh_given = matches!(mesh, Mesh::Given);
        let (discretisation, run, accurate) = solved(&problem, &formulation, mesh, stages)?;
        let doubts = plausible::doubts(&discretisation, &run);
        (problem.scene, problem.resolution) = (discretisation.scene.clone(), discretisation.resolution);
        stages.write();
        let mut checks = problem.own(&discretisation, &run)?;
        // The checks of a file are written for its own formulation, which may go further.
        let own = problem.formulation();
        if (formulation.element, formulation.algorithm) != (own.element, own.algorithm) {
            let accepted = run.formulation.settings.tolerance;
            checks = checks.into_iter().map(|check| check.as_far_as(accepted)).collect();
        }
        checks.extend(accurate.iter().map(|(asked, answer)| met(asked, answer)));
        let barred = || match &accurate {
            Some((asked, answer)) => {
                answer.bars(asked, &discretisation, &run).map(|bars| bars.estimated(&answer.estimates))
            }
            None => accuracy::bars(&discretisation, &run, &problem.displaced()),
        };
        let bars = with_bars.then(barred).transpose()?;
        if let Some(bars) = bars.as_ref().filter(|_| run.solution.converged()) {
            checks = checks.into_iter().map(|check| check.with_bar(&bars.all)).collect();
        }
        let reactions = reactions(&discretisation, &run)?;
        let displacement = discretisation.displacement_under(run.share(), &run.solution);
        let stresses = discretisation.largest_von_mises(&run, &displacement)?;
        Ok(Self {
            problem,
            discretisation,
            run,
            doubts,
            is_mesh_given,
            reactions,
            displacement,
            stresses,
            bars,
            checks,
            accurate,
        })
    }

    /// What must be known of a contact before it is quoted.
    pub fn notes_of(&self, contact: usize) -> Vec<String> {
        [notes::of(&self.run, contact), self.doubts[contact].clone()].concat()
    }

    /// What closed forms say that the run contradicts.
    pub fn notes(&self) -> Vec<String> {
        self.problem.notes(&self.run, self.barred())
    }

    /// Every number with its bar; none where bars were not asked for.
    pub fn barred(&self) -> &[Barred] {
        self.bars.as_ref().map_or(&[], |bars| &bars.all)
    }
}

/// The bodies on the mesh that is chosen, the run, and what came of an accuracy.
type Solved = (Discretisation, Run, Option<(accuracy::Asked, accuracy::Answer)>);

fn solved(problem: &Case, formulation: &Formulation, mesh: Mesh, stages: &Stages) -> Result<Solved, Error> {
    let begins = |stage| stages.begin(stage);
    let meshed = |scene, resolution| {
        let discretisation = Discretisation::timed(scene, resolution, Clock::telling(&begins))?;
        stages.begin(Stage::Iteration);
        Ok::<_, Error>(discretisation)
    };
    match mesh {
        Mesh::Given => {
            let discretisation = meshed(problem.scene.clone(), problem.resolution)?;
            let run = Run::of(&discretisation, formulation)?.with_limits(&discretisation)?;
            Ok((discretisation, run, None))
        }
        Mesh::Fitted(fitted) => {
            let answer = fitted.solve(&problem.scene, formulation)?;
            let run = answer.run.with_limits(&answer.discretisation)?;
            Ok((answer.discretisation, run, None))
        }
        Mesh::Accurate(asked) => {
            stages.search();
            let asked = accuracy::Asked { wanted: problem.displaced(), ..asked };
            let mut answer = accuracy::solve_telling(&problem.scene, formulation, &asked, &|next| stages.next(next))?;
            let held = answer.discretisation.take();
            let discretisation = held.map_or_else(|| meshed(answer.scene.clone(), answer.resolution), Ok)?;
            let run = answer.run.clone();
            Ok((discretisation, run, Some((asked, answer))))
        }
    }
}

/// What a support exerts on the modelled part of its body.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReactionReading {
    /// Name of the body.
    pub body: String,
    /// Where the support is: the name of a boundary, or the point of a node.
    pub at: Place,
    /// Which component it holds: `x` or `y`.
    pub component: &'static str,
    /// Force on the body along that component, positive along x or y \[N\].
    pub force: f64,
}

/// The reaction of every support, body by body in the order of the scene.
fn reactions(discretisation: &Discretisation, run: &Run) -> Result<Vec<ReactionReading>, Error> {
    let reading = |reaction: Reaction| {
        let body = &discretisation.scene.bodies[reaction.body];
        let support = &body.supports[reaction.support];
        ReactionReading {
            body: body.name.clone(),
            at: support.at.clone(),
            component: support.component.name(),
            force: reaction.force,
        }
    };
    Ok(discretisation.reactions(run.share(), &run.solution)?.into_iter().map(reading).collect())
}
