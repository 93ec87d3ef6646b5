//! What an accuracy costs, in sentences made of the record.

use crate::markdown::significant;
use crate::study::pairing::Pairing;
use crate::study::timings::code::Code;
use crate::study::timings::others::Peer;
use crate::study::timings::precision::{Family, LOADS, Point};
use crate::study::timings::record::Record;
use crate::study::timings::targets::{COMPARED, theirs};

/// Our cheapest meshes and formulations to the compared accuracy, then other codes.
pub fn conclusion(record: &Record) -> String {
    [ours(record), meshed_by_themselves(record), on_our_mesh(record)].concat()
}

/// The fastest point within the accuracy of each formulation that reaches it, cheapest first.
fn ranked(record: &Record) -> Vec<&Point> {
    let of = |pairing: Pairing| {
        let enough = |point: &&Point| {
            point.family != Family::Cylinder && point.formulation == pairing && point.error() <= COMPARED
        };
        record.points.iter().filter(enough).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
    };
    let mut ranked: Vec<&Point> = Pairing::all().into_iter().filter_map(of).collect();
    ranked.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    ranked
}

fn ours(record: &Record) -> String {
    let ranked = ranked(record);
    let asked =
        format!("{} % in peak and second-moment width, truncated Hertz, median of {LOADS} loads", 100.0 * COMPARED);
    let Some(best) = ranked.first() else { return format!("No formulation reaches {asked}. ") };
    let times = |point: &Point| significant(point.seconds / best.seconds, 2);
    let others = match &ranked[1..] {
        [] => "no other formulation reaches it".to_string(),
        [one] => format!("the only other one, `{}`, takes {} times as long", one.formulation, times(one)),
        [second, .., slowest] => format!(
            "of {} formulations that reach it the next, `{}`, takes {} times as long, the slowest, `{}`, {} times",
            ranked.len(),
            second.formulation,
            times(second),
            slowest.formulation,
            times(slowest)
        ),
    };
    format!(
        "**{asked}: {} ms by `{}` on {}-node cells with {} degrees of freedom**; {others}. ",
        significant(1e3 * best.seconds, 2),
        best.formulation,
        best.cell_nodes,
        best.dofs
    )
}

fn meshed_by_themselves(record: &Record) -> String {
    let told = Code::ALL.into_iter().filter_map(|code| {
        let beside = record.measured.beside.iter().find(|beside| beside.code == code)?;
        let found = theirs(record, code)?;
        let [least, most] = [beside.seconds.most, beside.seconds.least].map(|ours| found.seconds / ours);
        let ratio = found.seconds / beside.seconds.median;
        let [ratio, least, most] = [ratio, least, most].map(|ratio| significant(ratio, 2));
        Some(format!("{code} takes {ratio} times as long ({least} to {most} over the spread of ours)"))
    });
    let told: Vec<String> = told.collect();
    if told.is_empty() {
        String::new()
    } else {
        format!("To the same accuracy on meshes of their own {}. ", told.join(", "))
    }
}

fn on_our_mesh(record: &Record) -> String {
    let told = Peer::ALL.into_iter().filter_map(|code| {
        let own = record.measured.peers.iter().filter(|point| point.code == code);
        let mut ratios: Vec<f64> = own.map(|point| point.seconds.median / point.ours.median).collect();
        ratios.sort_by(f64::total_cmp);
        let [least, most] = [ratios.first()?, ratios.last()?].map(|ratio| significant(*ratio, 2));
        Some(format!("{} {least} to {most} times", code.name()))
    });
    let told: Vec<String> = told.collect();
    if told.is_empty() {
        String::new()
    } else {
        format!("On our meshes of the cylinder the contact solve takes {}.", told.join(", "))
    }
}
