//! Condensed matrices that are exported: a few lines of linear algebra find on them what the program says of the case.

use std::io::{Cursor, Read};

use contact_vv::case::library::find;
use contact_vv::cli::export::files;
use contact_vv::referee::export::condensed;
use contact_vv::study::sheet::BUILT_IN;
use nalgebra::{DMatrix, DVector};
use serde_json::Value;

use crate::outputs::json;

/// An array of the file.
fn array(bytes: &[u8], name: &str) -> Vec<f64> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("an archive");
    let mut text = Vec::new();
    archive.by_name(&format!("{name}.npy")).expect(name).read_to_end(&mut text).expect("read");
    npyz::NpyFile::new(&text[..]).expect("an array").into_vec().expect("numbers")
}

/// Pressures by an active set: points that pull open, points that penetrate close.
fn solved(s: &[f64], f: &[f64], b: &[f64], g: &[f64], area: &[f64]) -> Vec<f64> {
    let (n, m) = (f.len(), g.len());
    let (stiffness, rows) = (DMatrix::from_row_slice(n, n, s), DMatrix::from_row_slice(m, n, b));
    let mut closed: Vec<usize> = (0..m).filter(|&k| g[k].is_finite()).collect();
    for _ in 0..m {
        let c = closed.len();
        let own = DMatrix::from_fn(c, n, |row, column| rows[(closed[row], column)]);
        let mut system = DMatrix::zeros(n + c, n + c);
        system.view_mut((0, 0), (n, n)).copy_from(&stiffness);
        system.view_mut((0, n), (n, c)).copy_from(&own.transpose());
        system.view_mut((n, 0), (c, n)).copy_from(&own);
        let right = DVector::from_iterator(n + c, f.iter().copied().chain(closed.iter().map(|&k| g[k])));
        let found = system.lu().solve(&right).expect("regular");
        let approach = &rows * found.rows(0, n);
        let mut force = vec![0.0; m];
        closed.iter().zip(found.rows(n, c).iter()).for_each(|(&k, &own)| force[k] = own);
        let largest = force.iter().copied().fold(0.0, f64::max);
        let stays = |k: usize| match closed.contains(&k) {
            true => force[k] > -1e-10 * largest,
            false => approach[k] > g[k] + 1e-12,
        };
        let next: Vec<usize> = (0..m).filter(|&k| stays(k)).collect();
        if next == closed {
            return force.iter().zip(area).map(|(force, area)| force / area).collect();
        }
        closed = next;
    }
    panic!("no set stands");
}

#[test]
fn condensed_matrices_solved_by_a_few_lines_give_the_pressures_and_the_peak_that_solve_tells() {
    for name in ["cylinder", "pin-rod", "flat-punch"] {
        let all = files(&find(name, None).expect("a case"), true).expect("exported");
        let (_, bytes, _) = all.iter().find(|(file, ..)| file == condensed::FILE).expect("written");
        let [s, f, b, g, area, pressure] = ["S", "f", "B", "g", "A", "p"].map(|name| array(bytes, name));
        let found = solved(&s, &f, &b, &g, &area);
        let largest = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
        let told = json(&["solve", name, "--no-error-bar", "--tolerance", "1e-10"]);
        let peak = told["contacts"][0]["largest_point_pressure"].as_f64().expect("a peak");
        assert!((largest(&found) - peak).abs() <= 1e-8 * peak, "{name}: {} instead of {peak}", largest(&found));
        // The report's peak, of cells of high order; that of a punch has no limit.
        let cases: Vec<Value> = serde_json::from_str(BUILT_IN).expect("JSON");
        let values = cases.iter().filter(|one| one["case"] == name).flat_map(|one| one["values"].as_array());
        let known = values.flatten().find(|one| one["quantity"] == "peak-pressure").expect("a peak")["value"].as_f64();
        assert!(known.is_none_or(|known| (peak - known).abs() <= 1e-3 * known), "{name}: {peak}, {known:?}");
        for (k, (one, ours)) in found.iter().zip(&pressure).enumerate() {
            assert!((one - ours).abs() <= 1e-7 * peak, "{name}, point {k}: {one} instead of {ours}");
        }
        // Matrices that are 1 % too stiff are seen.
        let stiff: Vec<f64> = s.iter().map(|entry| 1.01 * entry).collect();
        let moved = solved(&stiff, &f, &b, &g, &area);
        let apart = moved.iter().zip(&pressure).map(|(one, ours)| (one - ours).abs()).fold(0.0, f64::max);
        assert!(name == "flat-punch" || apart > 1e-3 * peak, "{name}: {apart}");
        let sheet = String::from_utf8(all[0].1.clone()).expect("text");
        assert!(sheet.ends_with(condensed::TEXT), "{name}");
    }
}
