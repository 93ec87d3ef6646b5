//! The paper's statements, judged from the numbers of the studies: no verdict and no condition here is typed.

use crate::case::judged::worst;
use crate::case::library::{cylinder, pin_rod};
use crate::case::{Quantity, Verdict};
use crate::markdown::{self, Column};
use crate::measure::{Quantity as Number, larger};
use crate::solve::{Element, Iteration, Run, Settings};
use crate::study::atlas::{Chart, Plane, Record};
use crate::study::measured::GAERTNER;
use crate::study::method::Method;
use crate::study::paper::reading::Reading;
use crate::study::paper::sentence::Sentence;
use crate::study::paper::statement::{self, Judgement, Statement};
use crate::study::refinement::{self, Change, LEFT_OUT};
use crate::study::{Finding, Study, cases, measured, paper};
use crate::uncertainty::COVERAGE;

/// Cases beside the paper's own study whose findings are asked.
pub const CASES: [&str; 4] = [refinement::QUARTER, cylinder::NINE, pin_rod::NINE, GAERTNER];

/// All statements, judged; what is not among the findings is not judged.
pub fn judge(findings: &[Finding]) -> Vec<Statement> {
    let sentences = findings.iter().filter_map(|finding| {
        let numbers: &paper::Numbers = finding.numbers()?;
        Some(Sentence::ALL.into_iter().zip(statement::statements(numbers)))
    });
    let others = [top_quarter(findings), condensation_pays(findings), gaertner(findings)];
    let with_others = |(sentence, one): (Sentence, Statement)| match sentence {
        Sentence::Agrees => with_reference(one, findings),
        Sentence::LineAlways => {
            let (clause, measured) =
                (format!("{}; but {}", one.clause, by_error()), format!("{}. But {}", one.measured, by_error()));
            Statement { clause, measured, ..one }
        }
        _ => one,
    };
    sentences.flatten().map(with_others).chain(others).collect()
}

/// How they are judged, and all of them, for the page on the paper.
pub fn section(findings: &[Finding]) -> String {
    let columns: [Column<Statement>; 3] = [
        ("statement", |one| one.text.into()),
        ("measured", |one| markdown::capitalised(&one.measured)),
        ("judgement", |one| match &one.judgement {
            Judgement::Undecidable(why) => format!("{}: it {why}", linked(&one.judgement, "paper.md#sources")),
            judgement => format!("**{judgement}**"),
        }),
    ];
    let table = markdown::columns(&columns, &judge(findings));
    format!(
        "## Its statements\n\n{} What is measured of iterations is of cylinder and pin–rod, in this order, under that \
        reading, by a cap of {}.\n\n{table}\n",
        statement::RULE,
        Reading::nearest().cap
    )
}

/// How the paper's varying stiffness with line elements ends on its scenes where the error stops it, as the atlas has
/// recorded.
fn by_error() -> String {
    let Settings { tolerance, max_iterations, .. } = Settings::default();
    let method = Method::usual(Element::Line, Iteration::Varying);
    let of_scene = |plane: Plane| {
        let chart = Chart::read(plane).ok()?;
        let own: Vec<&Record> = chart.of_method(method).flatten().collect();
        let right = own.iter().filter(|record| record.is_right()).count();
        let Record { ordinate, .. } = own.first()?;
        Some(format!("{right} of {} initial stiffnesses on {} ({ordinate} {})", own.len(), plane.name(), plane.label()))
    };
    let all: Vec<String> = Plane::PAPER.into_iter().filter_map(of_scene).collect();
    format!(
        "stopped by its error of {tolerance:e}, within {max_iterations} iterations, `{method}` ends right from {}",
        all.join(" and from ")
    )
}

/// The clause that tells why what fails by the error may converge in every case by the statement of the paper.
pub fn two_stops() -> String {
    let stop = Reading::nearest().stop.name();
    format!(
        "Every run here stops by its error, and the paper's statements are judged by {stop}, which a run can meet \
        before: there a method may end in every case that is given up here. {}.\n",
        markdown::capitalised(&by_error())
    )
}

fn of_case<'a>(findings: &'a [Finding], case: &str) -> impl Iterator<Item = &'a Finding> {
    findings.iter().filter(move |finding| finding.case == case)
}

/// A judgement in short, with the link to what would decide it where that is not at hand.
pub fn linked(judgement: &Judgement, sources: &str) -> String {
    let told = format!("**{}**", judgement.brief());
    if matches!(judgement, Judgement::Undecidable(_)) { format!("[{told}]({sources})") } else { told }
}

/// A statement by its clause, what was measured, and the judgement; not judged where nothing was found.
fn statement(text: &'static str, found: Option<(String, String, Judgement)>) -> Statement {
    let nothing = || ("not asked".into(), "not asked".into(), Judgement::NotJudged);
    let (clause, measured, judgement) = found.unwrap_or_else(nothing);
    Statement { text, clause, measured, judgement }
}

/// The statement on agreement, which is of iterations with the discrete solution, with what this is off of Hertz and of
/// the others: where that is more than the checks allow, nothing is reproduced.
fn with_reference(statement: Statement, findings: &[Finding]) -> Statement {
    let both = passes(findings, cylinder::NINE).zip(passes(findings, pin_rod::NINE));
    let Some((cylinder, rod)) = both else { return statement };
    let worst = |case: &str, quantity: Quantity| 100.0 * error(findings, case, quantity);
    let [peak, rod_peak] = [cylinder::NINE, pin_rod::NINE].map(|case| worst(case, Number::PeakPressure.into()));
    let width = worst(cylinder::NINE, Number::SecondMomentWidth.into());
    let means = worst(pin_rod::NINE, Quantity::EdgeMeans);
    let measured = format!(
        "{}. By the discrete solutions of all nine: p₀ within {peak:.2} % of Hertz, a within {width:.2} %, pin–rod \
        peak within {rod_peak:.2} %, edge means within {means:.2} %",
        statement.measured
    );
    let judgement = if cylinder && rod { statement.judgement } else { Judgement::NotReproduced };
    Statement { measured, judgement, ..statement }
}

/// Largest error of a quantity over all runs of a case; NaN where none was judged.
fn error(findings: &[Finding], case: &str, quantity: impl Into<Quantity>) -> f64 {
    let (judged, quantity) = (of_case(findings, case).flat_map(|finding| &finding.judged), quantity.into());
    let errors = judged.filter(|judged| judged.check.quantity == quantity).map(|judged| judged.error);
    errors.reduce(larger).unwrap_or(f64::NAN)
}

/// Whether every check of a case passed; none where it was not run.
fn passes(findings: &[Finding], case: &str) -> Option<bool> {
    worst(of_case(findings, case).flat_map(|finding| &finding.judged)).map(|worst| *worst == Verdict::Pass)
}

/// The upper quarter may be left out.
fn top_quarter(findings: &[Finding]) -> Statement {
    let changes = findings.iter().find_map(|finding| match finding.numbers() {
        Some(refinement::Numbers::Quarter(changes)) => Some(changes),
        _ => None,
    });
    let found = changes.map(|changes| {
        let is_small = |change: &&Change| change.largest() <= LEFT_OUT;
        let small = changes.iter().filter(is_small).map(|change| change.a_over_r).fold(0.0, f64::max);
        let told = |change: &Change| format!("{:.3} % at a/R = {}", 100.0 * change.largest(), change.a_over_r);
        let all = changes.iter().map(told).collect::<Vec<_>>().join(", ");
        let below = format!("below {} % up to a/R = {small}", 100.0 * LEFT_OUT);
        let judgement = match changes.iter().all(|change| is_small(&change)) {
            false if small > 0.0 => Judgement::OnlyIf(format!("a/R is at most {small}")),
            holds => Judgement::of(holds),
        };
        (format!("change {below}"), format!("change of p₀ or a: {all}; {below}"), judgement)
    });
    statement("The top quarter of the half cylinder does not influence the contact and may be left out", found)
}

/// Condensation pays.
fn condensation_pays(findings: &[Finding]) -> Statement {
    let both = [cylinder::NINE, pin_rod::NINE].into_iter().flat_map(|case| of_case(findings, case));
    let refactoring = both.filter_map(|finding| match finding.numbers::<cases::Numbers>() {
        Some(numbers) if numbers.run.formulation.algorithm != Iteration::Constant => Some(&numbers.run),
        _ => None,
    });
    // Without condensation every factorisation would be the sparse one; with it there is one, and dense small ones.
    let gain = |run: &Run| {
        run.sparse_operations * run.solution.work.factorisations as f64
            / (run.sparse_operations + run.solution.work.operations)
    };
    let gains: Vec<f64> = refactoring.map(gain).collect();
    // NaN where one is.
    let [low, high] = gains.iter().fold([f64::INFINITY, 0.0], |[low, high], x| [-larger(-low, -x), larger(high, *x)]);
    let measured = format!(
        "operations without over with condensation, where the algorithm factorises at every iteration: {low:.1} to \
        {high:.0}; with constant stiffness one factorisation serves either way"
    );
    let clause = format!("{low:.1} to {high:.0} times the operations without");
    let found = (!gains.is_empty()).then(|| (clause, measured, Judgement::of(low > 1.0)));
    statement("It pays to iterate on the external dofs alone (substructuring)", found)
}

/// Gaertner's curves.
fn gaertner(findings: &[Finding]) -> Statement {
    let own = of_case(findings, GAERTNER).find(|finding| finding.study == measured::Numbers::NAME);
    let found = own.map(|own| match own.verdict() {
        Verdict::Pass => (format!("every point within {COVERAGE} u_val"), Judgement::Reproduced),
        Verdict::Fail => (format!("a point beyond {COVERAGE} u_val"), Judgement::NotReproduced),
        Verdict::NotRun(why) => (why, Judgement::NotJudged),
    });
    let found = found.map(|(measured, judgement)| (measured.clone(), measured, judgement));
    statement("Reasonable agreement with Gaertner's finite elements and experiment (Figs 14, 15)", found)
}
