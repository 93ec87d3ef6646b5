//! Iterations from every initial stiffness: when each criterion would have stopped them, and how far off they were
//! then; how a sentence fares over the designed set — under the nearest reading, and by which departures — and what is
//! made of it.

use std::fmt;

use rayon::prelude::*;

use crate::algorithm::Criterion;
use crate::case::library::{Cylinder, PinRod};
use crate::error::{Error, Kind};
use crate::markdown;
use crate::mesh::{Order, Resolution};
use crate::named::named_enum;
use crate::solution::{Iterated, Outcome, Solution};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run, Settings};
use crate::study::grouped::{counted, in_order};
use crate::study::paper::reading::{Axis, CAPS, Candidates, JUDGED, Mesh, Reading, Rule, Stop, told};
use crate::study::paper::sentence::{Met, Seen, Sentence, Starts, agrees};

named_enum! {
    /// One of the paper's two examples.
    pub enum Example {
        /// Elastic cylinder on a rigid plane.
        Cylinder = "cylinder",
        /// Pin in a connecting rod.
        PinRod = "pin–rod",
    }
}

/// What iterates: an element with an algorithm on a mesh, however it is stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Example.
    pub example: Example,
    /// How far the candidates reach.
    pub candidates: Candidates,
    /// Mesh.
    pub mesh: Mesh,
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: Rule,
    /// Thickness of a layer element over the length of its edge.
    pub thickness: f64,
}

/// All starts of a site.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// The site.
    pub site: Site,
    /// Dofs of the condensed system.
    pub retained: usize,
    /// Every stop that a reading asks of it.
    pub stops: Vec<Stop>,
    /// By start, when each stop was met.
    pub met: Vec<Vec<Option<Met>>>,
    /// Of some starts when a stop was met: as a run without it tells, and by a run that it stops.
    pub alone: Vec<[Option<Met>; 2]>,
    /// Of the nearest reading each start that its cap ends beside one that it does not, and when its stop is met by a
    /// cap [`LONGER`] times as large.
    pub later: Vec<(f64, Option<Met>)>,
}

/// Initial stiffnesses κ₀: whole decades.
pub fn starts() -> Vec<f64> {
    (-3..=6).map(|k| 10f64.powi(k)).collect()
}

/// The smallest iteration error that may be asked for: what no visible criterion waits for.
const LEAST: f64 = 1e-13;
/// Of the nearest reading one start in so many is run once more, by all stops in turn.
const AGAIN: usize = 3;

/// How many times the cap of the nearest reading a run is given that this ends.
pub const LONGER: usize = 10;

/// The paper's elements with its algorithms.
pub fn shown() -> impl Iterator<Item = (Element, Iteration)> {
    Formulation::nine().into_iter().filter(Formulation::is_in_the_paper).map(|one| (one.element, one.algorithm))
}

/// Every start of every site of some readings, on meshes that are made once.
pub fn courses(readings: &[Reading]) -> Result<Vec<Course>, Error> {
    let all = readings.iter().flat_map(|reading| Example::ALL.map(|example| (reading, example)));
    let asked = all.flat_map(|(reading, example)| Site::all(reading, example).map(|site| (site, reading.stop)));
    let once = |stops: Vec<Stop>| counted(stops).into_iter().map(|(stop, _)| stop).collect();
    let mut sites: Vec<(Site, Vec<Stop>)> =
        in_order(asked).into_iter().map(|(site, stops)| (site, once(stops))).collect();
    let ground = |(site, _): &(Site, Vec<Stop>)| (site.example, site.candidates, site.mesh);
    sites.sort_by_key(ground);
    let parts: Vec<&[(Site, Vec<Stop>)]> = sites.chunk_by(|a, b| ground(a) == ground(b)).collect();
    let on = |part: &&[(Site, Vec<Stop>)]| {
        let discretisation = part[0].0.discretised()?;
        part.par_iter().map(|(site, stops)| site.course(&discretisation, stops)).collect::<Result<Vec<_>, Error>>()
    };
    Ok(parts.par_iter().map(on).collect::<Result<Vec<_>, _>>()?.concat())
}

impl Example {
    /// Elements of its mesh, on what.
    fn elements(self) -> (usize, &'static str) {
        match self {
            Self::Cylinder => (8, "on Hertz's half-width"),
            Self::PinRod => (12, "on 10 mm of arc"),
        }
    }
}

impl Site {
    /// All of an example under a reading; line and node elements have no thickness.
    fn all(reading: &Reading, example: Example) -> impl Iterator<Item = Self> {
        let Reading { candidates, mesh, .. } = *reading;
        shown().map(move |(element, algorithm)| {
            let thickness = if element == Element::Layer { reading.thickness } else { Reading::nearest().thickness };
            Self { example, candidates, mesh, element, algorithm, rule: reading.rule(algorithm), thickness }
        })
    }

    /// The mesh with its condensed system; candidates that end with a contact without a closed form have to be looked
    /// for.
    fn discretised(&self) -> Result<Discretisation, Error> {
        let (elements, _) = self.example.elements();
        let (elements, order) = match self.mesh {
            Mesh::Sweep => (elements, Order::Quadratic),
            Mesh::Linear => (elements, Order::Linear),
            Mesh::Finer => (elements + elements / 2, Order::Quadratic),
        };
        let resolution = Resolution { elements, refinement: 0, order };
        let scene = match (self.example, self.candidates) {
            (Example::Cylinder, Candidates::Wide) => Cylinder::default().scene(),
            (Example::Cylinder, Candidates::AtEdge) => Cylinder { stretch: 1.0, ..Default::default() }.scene(),
            (Example::PinRod, Candidates::Wide) => PinRod::default().scene(),
            (Example::PinRod, Candidates::AtEdge) => {
                let wide = Discretisation::of(PinRod::default().scene(), resolution)?;
                let stretch = Run::of(&wide, &Formulation::verification())?.measures().edge();
                PinRod { stretch, ..Default::default() }.scene()
            }
        };
        Discretisation::of(scene, resolution)
    }

    /// All starts; kinematic load looks at the tolerance, and is run for each stop. Of the others one run tells of all.
    fn course(&self, discretisation: &Discretisation, stops: &[Stop]) -> Result<Course, Error> {
        let is_kinematic = self.algorithm == Iteration::Kinematic;
        let Reading { stop: nearest, cap, .. } = Reading::nearest();
        let met = |stiffness: f64| match is_kinematic {
            true => stops.iter().map(|stop| self.alone(discretisation, stiffness, stop, cap)).collect(),
            false => self.together(discretisation, stiffness, stops),
        };
        let met = starts().into_iter().map(met).collect::<Result<Vec<Vec<Option<Met>>>, Error>>()?;
        let is_nearest = Self::all(&Reading::nearest(), self.example).any(|site| site == *self);
        let again = if is_nearest && !is_kinematic { starts() } else { Vec::new() };
        let pair = |(start, stiffness): (usize, f64)| {
            let stop = (start + self.element as usize) % stops.len();
            Ok([met[start][stop], self.alone(discretisation, stiffness, &stops[stop], cap)?])
        };
        let alone = again.into_iter().enumerate().step_by(AGAIN).map(pair).collect::<Result<_, Error>>()?;
        let own = stops.iter().position(|stop| *stop == nearest).filter(|_| is_nearest);
        let ended: Vec<bool> = met.iter().map(|met| own.is_some_and(|own| met[own].is_none())).collect();
        let is_last = |start: &usize| {
            ended[*start] && (ended[..*start].last() == Some(&false) || ended.get(start + 1) == Some(&false))
        };
        let later = |start: usize| {
            let stiffness = starts()[start];
            Ok((stiffness, self.alone(discretisation, stiffness, &nearest, LONGER * cap)?))
        };
        let later = (0..ended.len()).filter(is_last).map(later).collect::<Result<_, Error>>()?;
        Ok(Course {
            site: *self,
            retained: discretisation.condensed.retained(),
            stops: stops.into(),
            met,
            alone,
            later,
        })
    }

    /// One run, and where it passed each stop: it ends by the hardest of them where they are of one criterion, else by
    /// nothing visible.
    fn together(&self, on: &Discretisation, stiffness: f64, stops: &[Stop]) -> Result<Vec<Option<Met>>, Error> {
        let least = stops.iter().map(|stop| stop.tolerance).fold(f64::INFINITY, f64::min);
        let hardest = match stops.chunk_by(|a, b| a.criterion == b.criterion).count() {
            1 => Stop { tolerance: least, ..stops[0] },
            _ => Stop { criterion: Criterion::Error, tolerance: LEAST },
        };
        let history = self
            .solved(on, stiffness, &hardest, Reading::nearest().cap)?
            .map_or(Vec::new(), |solution| solution.history);
        let met = |stop: &Stop| {
            let is_met = |one: &Iterated| stop.criterion.of(&one.seen).is_some_and(|seen| seen <= stop.tolerance);
            let at = history.iter().position(is_met)?;
            Some(Met { iterations: at + 1, error: history[at].error.peak })
        };
        Ok(stops.iter().map(met).collect())
    }

    /// A run of its own that stops by a criterion.
    fn alone(&self, on: &Discretisation, stiffness: f64, stop: &Stop, cap: usize) -> Result<Option<Met>, Error> {
        let ended = |solution: &Solution| [Outcome::Converged, Outcome::Stopped].contains(&solution.outcome);
        let solution = self.solved(on, stiffness, stop, cap)?.filter(ended);
        Ok(solution.map(|one| Met { iterations: one.work.iterations, error: one.error().peak }))
    }

    /// A solution; none where no spring holds, the named error.
    fn solved(&self, on: &Discretisation, stiffness: f64, stop: &Stop, cap: usize) -> Result<Option<Solution>, Error> {
        let Self { element, algorithm, rule: Rule { rule, leeway }, thickness: layer_thickness, .. } = *self;
        let plain = Formulation::new(element, algorithm);
        let Stop { criterion, tolerance } = *stop;
        let settings = Settings { criterion, tolerance, max_iterations: cap, ..plain.settings };
        match on.solve(&Formulation { rule, leeway, stiffness, layer_thickness, settings, ..plain }) {
            Err(Error { kind: Kind::NoSpringLeft { .. } | Kind::SpringsTooSoft, .. }) => Ok(None),
            solution => solution.map(Some),
        }
    }
}

/// What the paper shows of an example under a reading; no start of a site or a stop that was not run.
pub fn seen(courses: &[Course], reading: &Reading, example: Example) -> Seen {
    let starts = |site: Site| {
        let course = courses.iter().find(|course| course.site == site);
        let asked = course.and_then(|own| Some((own, own.stops.iter().position(|stop| *stop == reading.stop)?)));
        let (retained, met) = asked.map_or((0, Vec::new()), |(own, at)| {
            let met = own.met.iter().map(|met| met[at].filter(|met| met.iterations <= reading.cap));
            (own.retained, met.collect())
        });
        Starts { element: site.element, algorithm: site.algorithm, retained, met }
    };
    Seen { of: Site::all(reading, example).map(starts).collect() }
}

/// How a statement of the paper fared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It holds as stated.
    Reproduced,
    /// It holds under this condition, which the paper does not state.
    OnlyIf(String),
    /// It hangs on the rule by which stiffnesses change, which the paper's reference 12 would tell: so it does
    /// otherwise.
    Undecidable(String),
    /// It does not hold here.
    NotReproduced,
    /// Nothing to judge it by.
    NotJudged,
}

impl Judgement {
    /// Reproduced or not.
    pub fn of(holds: bool) -> Self {
        if holds { Self::Reproduced } else { Self::NotReproduced }
    }

    /// The kind of judgement.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::OnlyIf(_) => "reproduced on a condition",
            Self::Undecidable(_) => "not decidable without [12]",
            Self::NotReproduced => "not reproduced",
            Self::NotJudged => "not judged",
        }
    }

    /// The judgement without what would decide it.
    pub fn brief(&self) -> String {
        match self {
            Self::OnlyIf(condition) => format!("only if: {condition}"),
            _ => self.word().into(),
        }
    }
}

impl fmt::Display for Judgement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OnlyIf(condition) => write!(f, "reproduced only if: {condition}"),
            Self::Undecidable(condition) => write!(f, "{}: it {condition}", self.word()),
            _ => f.write_str(self.word()),
        }
    }
}

/// A statement of the paper with what was measured.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What the paper says.
    pub text: &'static str,
    /// The one number that tells most.
    pub clause: String,
    /// What was measured.
    pub measured: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// How a judgement is made, for the page.
pub const RULE: &str = "What the paper says of iterations is judged under the reading nearest to its text, at three \
    tolerances, and beside it under every single departure that keeps the agreement with the exact solution; that \
    agreement itself, under every one. Where a statement fails at all three tolerances, it is not reproduced; where \
    it holds at some of them, it is reproduced only there. Where it holds at all three and no other rule of stiffness \
    flips it, it is reproduced; where another rule does, it is not decidable without [[12]](paper.md#sources), the \
    paper's reference on that rule, which is not at hand. What is told start by start, that one algorithm takes fewer \
    iterations or can save operations, is reproduced where it holds under the nearest reading. The choices that flip \
    a statement are told with every judgement.";

/// What the paper's reference 12 would tell.
const RULES: [Axis; 2] = [Axis::Varying, Axis::Constant];

/// The sentences of the paper, judged over the courses of the designed set.
pub fn statements(courses: &[Course]) -> Vec<Statement> {
    let both = |reading: &Reading| Example::ALL.map(|example| seen(courses, reading, example));
    let nearest = both(&Reading::nearest());
    let agrees = |reading: &Reading| agrees(&both(reading));
    let judged = |sentence: Sentence| {
        let fared = match sentence {
            Sentence::Agrees => Fared::agreement(courses),
            _ => Fared::by(|reading| sentence.holds(&both(reading)), agrees),
        };
        let one = statement(sentence, &nearest, &fared);
        match sentence {
            Sentence::Fails => Statement { measured: format!("{}. {}", one.measured, ended_later(courses)), ..one },
            _ => one,
        }
    };
    Sentence::ALL.map(judged).into()
}

/// The readings, single departures and pairs, under which most sentences hold together, and which do not there: as each
/// statement is judged, a sentence holds where it does at each tolerance of [`Reading::judged`].
pub fn most_fulfilled(courses: &[Course]) -> Vec<(Reading, Vec<Sentence>)> {
    let open = |reading: &Reading| {
        let at = reading.judged().into_iter().map(|one| Example::ALL.map(|example| seen(courses, &one, example)));
        let at: Vec<[Seen; 2]> = at.collect();
        Sentence::ALL.into_iter().filter(|sentence| !at.iter().all(|seen| sentence.holds(seen))).collect::<Vec<_>>()
    };
    let readings = [vec![Reading::nearest()], Reading::departures(), Reading::pairs()].concat();
    let mut all: Vec<_> = readings.into_iter().map(|reading| (reading, open(&reading))).collect();
    let fewest = all.iter().map(|(_, open)| open.len()).min();
    all.retain(|(_, open)| Some(open.len()) == fewest);
    all
}

fn statement(sentence: Sentence, nearest: &[Seen; 2], fared: &Fared) -> Statement {
    let count = fared.held.iter().filter(|held| **held).count();
    let flips = |axis: &Axis| fared.flips.iter().any(|one| one.axes() == [*axis]);
    let axes: Vec<String> =
        Axis::ALL.iter().filter(|axis| flips(axis)).map(|axis| axis.title().to_lowercase()).collect();
    let otherwise = if fared.holds() { "fails" } else { "holds" };
    let flips = match axes.is_empty() {
        true => "none flips it".into(),
        false => format!("it {otherwise} with another {}", axes.join(", or ")),
    };
    let cap = match sentence {
        Sentence::Fails => format!(
            " by a cap of {}{}",
            Reading::nearest().cap,
            if CAPS.into_iter().all(|cap| cap <= Reading::nearest().cap) {
                ", the largest of all departures"
            } else {
                ""
            }
        ),
        _ => String::new(),
    };
    let starts = sentence.starts(nearest);
    let on = match sentence {
        Sentence::LineAlways | Sentence::Proviso | Sentence::KinematicAlways => format!(", {}", scenes()),
        _ => String::new(),
    };
    let measured = [vec![sentence.numbers(nearest) + &on, fared.at()], fared.clauses()].concat();
    let measured = starts.iter().chain(&measured).map(|one| markdown::capitalised(one));
    Statement {
        text: sentence.name(),
        measured: measured.collect::<Vec<_>>().join(". "),
        clause: format!(
            "{}holds at {count} of {} tolerances{cap}{on}; of {} departures counted {flips}",
            starts.map_or(String::new(), |starts| starts + "; "),
            fared.held.len(),
            fared.counted
        ),
        judgement: fared.judgement(sentence),
    }
}

/// The scenes on which the paper's cases are run here, with the mesh of the nearest reading.
fn scenes() -> String {
    let told = |example: Example| {
        let (elements, on) = example.elements();
        format!("{} ({}, {elements} {on})", example.name(), Reading::nearest().mesh.name())
    };
    format!("on {}", Example::ALL.map(told).join(" and "))
}

/// When runs that the cap of the nearest reading ends do end by a larger one.
pub fn later(courses: &[Course]) -> String {
    let told = |course: &Course| {
        let Site { example, element, algorithm, .. } = course.site;
        let after = |met: &Option<Met>| met.map_or("not".into(), |met| format!("after {} iterations", met.iterations));
        let each = course.later.iter().map(|(stiffness, met)| format!("{} from κ₀ = {stiffness:e}", after(met)));
        let each: Vec<String> = each.collect();
        let of = || format!("{} by {} + {} {}", example.name(), element.name(), algorithm.name(), each.join(" and "));
        (!each.is_empty()).then(of)
    };
    courses.iter().filter_map(told).collect::<Vec<_>>().join("; ")
}

/// How many of these end by the larger cap, and after how many iterations.
fn ended_later(courses: &[Course]) -> String {
    let all = || courses.iter().flat_map(|course| &course.later);
    let mut ended: Vec<usize> = all().filter_map(|(_, met)| Some((*met)?.iterations)).collect();
    ended.sort_unstable();
    let after = |most: &usize| format!(", after {} to {most} iterations", ended[0]);
    format!(
        "Of {} starts that the cap ends beside one that it does not, {} end by one {LONGER} times as large{}",
        all().count(),
        ended.len(),
        ended.last().map_or(String::new(), after)
    )
}

/// A sentence over the designed set. Under a reading it holds where it does at each tolerance that the reading is
/// judged at.
///
/// A departure counts only where every combination still agrees with the exact solution: the paper's do, so that a rule
/// or a stop under which they do not is not the paper's.
pub struct Fared {
    /// Whether it holds under the nearest reading, at each tolerance of [`JUDGED`].
    pub held: [bool; JUDGED.len()],
    /// How many single departures count.
    pub counted: usize,
    /// Single departures under which it holds where it else does not, or fails where it else holds.
    pub flips: Vec<Reading>,
    /// Pairs that flip it where neither part does.
    pub together: Vec<Reading>,
    /// Pairs that do not where a part does.
    pub undone: Vec<Reading>,
}

impl Fared {
    /// The agreement itself, of which every departure counts.
    pub fn agreement(courses: &[Course]) -> Self {
        Self::by(|reading| agrees(&Example::ALL.map(|example| seen(courses, reading, example))), |_| true)
    }

    /// A sentence of which it is known under which readings it holds, and which readings count.
    pub fn by(holds: impl Fn(&Reading) -> bool, counts: impl Fn(&Reading) -> bool) -> Self {
        let held = JUDGED.map(|tolerance| holds(&Reading::nearest().at(tolerance)));
        let own = held.iter().all(|held| *held);
        let counted = |mut of: Vec<Reading>| {
            of.retain(|reading| reading.judged().iter().all(&counts));
            of
        };
        let flips = |reading: &Reading| reading.judged().iter().all(&holds) != own;
        let mut singles = counted(Reading::departures());
        let of = singles.len();
        singles.retain(flips);
        let (mut undone, mut together): (Vec<Reading>, Vec<Reading>) = counted(Reading::pairs())
            .into_iter()
            .partition(|pair| pair.parts().iter().any(|part| singles.contains(part)));
        undone.retain(|pair| !flips(pair));
        together.retain(flips);
        Self { held, counted: of, flips: singles, together, undone }
    }

    /// Whether it holds under the nearest reading.
    fn holds(&self) -> bool {
        self.held.iter().all(|held| *held)
    }

    /// What the departures that flip it make of it.
    fn otherwise(&self) -> &'static str {
        if self.holds() { "fails if" } else { "holds if" }
    }

    /// Whether it holds at each tolerance, in words.
    pub fn at(&self) -> String {
        let at = JUDGED.iter().zip(self.held);
        let at = at.map(|(tolerance, held)| format!("{} at {tolerance:.0e}", if held { "holds" } else { "fails" }));
        at.collect::<Vec<_>>().join(", ")
    }

    /// Which choices flip it, in words.
    pub fn told(&self) -> String {
        self.clauses().join("; ")
    }

    /// The same, clause by clause.
    fn clauses(&self) -> Vec<String> {
        let otherwise = self.otherwise();
        let clause = |begins: &str, (k, one): (usize, String)| format!("{} {one}", if k == 0 { begins } else { "or" });
        let all = [
            (otherwise.to_owned(), &self.flips),
            (format!("{otherwise} together"), &self.together),
            ("not so if".into(), &self.undone),
        ];
        let all =
            all.iter().flat_map(|(begins, of)| told(*of).into_iter().enumerate().map(move |one| clause(begins, one)));
        let mut all: Vec<String> = all.collect();
        if all.is_empty() {
            all.push("none flips it".into());
        }
        all[0] = format!("of {} departures counted: {}", self.counted, all[0]);
        all
    }

    /// The judgement that follows of a sentence.
    pub fn judgement(&self, of: Sentence) -> Judgement {
        let is_rule = |one: &&Reading| one.axes().iter().all(|axis| RULES.contains(axis));
        let by_rule: Vec<&Reading> = self.flips.iter().filter(is_rule).collect();
        let at = JUDGED.iter().zip(self.held).filter(|(_, held)| *held).map(|(one, _)| format!("{one:.0e}"));
        let at: Vec<String> = at.collect();
        match at.len() {
            0 => Judgement::NotReproduced,
            some if some < JUDGED.len() => Judgement::OnlyIf(format!("the tolerance is {}", at.join(" or "))),
            _ if by_rule.is_empty() || of.by_start().is_some() => Judgement::Reproduced,
            _ => Judgement::Undecidable(format!("{} {}", self.otherwise(), told(by_rule).join("; or "))),
        }
    }
}
