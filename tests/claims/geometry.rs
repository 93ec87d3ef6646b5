//! Rings on flats, closed boundaries of Gmsh meshes, clearances beside profiles, waves that are pressed flat, and rigid
//! pins in plates: these have no closed form but that of small angles, and are held by geometry, equilibrium, that
//! limit, and a very stiff pin.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};

use approx::assert_relative_eq;
use contact_vv::case::{Case, Meshed, Verdict};
use contact_vv::error::Error;
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::oracle::analytic::waves::Waves;
use contact_vv::scene::{Circle, Profile};
use contact_vv::solve::Run;

use crate::balance;
use crate::mesh_files::{Body, Coding, msh};
use crate::outputs::{UNITS, contact_vv};
use crate::program::Folder;
use crate::scene_file::{changed, text_of, with_key};
use crate::workbench::{parsed, refused};

const BLOCK: &str = "[[body]]\nname = \"block\"\nyoung = 70e3\npoisson = 0.3\n\
    shape = { rectangle = { x = [0, 60], y = [-60, 0], contact = \"top\" } }\n\
    supports = [{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"y\" }]\n[contact]\n";
const START: &str = "[{ at = \"start\", component = \"x\" }]";
const ON_START: &str = "{ at = \"start\", component = \"x\" }, { at = \"end\", component = \"x\" }";
const TWO_POINTS: &str = "{ at = [0, 20], component = \"x\" }, { at = [0, 80], component = \"x\" }";

/// The ring on a flat, with other values of some keys.
fn ring(keys: &[(&str, &str)]) -> String {
    keys.iter().fold(balance::text("ring-on-flat"), |text, (key, value)| with_key(&text, key, value))
}

fn solved(text: &str) -> (Case, Meshed, Run) {
    let case = parsed(text);
    let (meshed, run) = case.solve().unwrap_or_else(|error| panic!("{error}\n{text}"));
    (case, meshed, run)
}

/// Peak \[MPa\], second-moment width \[mm\] and resultant \[N\].
fn numbers(text: &str) -> [f64; 3] {
    of_run(&solved(text).2)
}

fn of_run(run: &Run) -> [f64; 3] {
    let measures = run.measures();
    [measures.peak.pressure, measures.second_moment_width, run.contacts[0].transmitted]
}

fn approach(meshed: &Meshed, run: &Run) -> f64 {
    let displacement = meshed.discretisation.displacement_under(run.share(), &run.solution);
    meshed.discretisation.approach(&displacement, 0).expect("found").expect("an approach")
}

fn assert_alike(found: [f64; 3], wanted: [f64; 3], within: f64, what: &str) {
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found / wanted - 1.0).abs() <= within, "{what}: {found} and not {wanted}");
    }
}

#[test]
fn thick_ring_on_a_flat_has_the_contact_of_hertz_and_of_a_disc() {
    let pressed = |shape: &str, supports: &str, side: &str, traction: f64| {
        let loads = format!("[{{ traction = {{ at = \"{side}\", value = [0, {traction}] }} }}]");
        let keys = [("shape", shape), ("supports", supports), ("loads", &loads)];
        numbers(&ring(&[&keys[..], &[("stretch", "1.8"), ("elements", "16"), ("per", "0.9")]].concat()))
    };
    let thick = "{ ring = { centre = [0, 50], inner = 2, outer = 50, sweep = 90, contact = \"outer\" } }";
    let ring = pressed(thick, START, "end", -30.0 * 50.0 / 48.0);
    let axis = "[{ at = \"axis\", component = \"x\" }]";
    let disc = pressed("{ disc = { centre = [0, 50], radius = 50 } }", axis, "cut", -30.0);
    let hertz = Hertz { load: 3000.0, radius: 50.0, modulus: 210e3 / 0.91 };
    assert_alike(ring, [hertz.peak_pressure(), hertz.half_width(), 3000.0], 1.5e-3, "Hertz");
    assert_alike(ring, disc, 2e-4, "a disc");
}

#[test]
fn thin_ring_on_a_flat_gives_way_as_a_curved_beam() {
    // Half of the diametral compression under two forces P, `P R³ (π/4 − 2/π)/EI`, I = h³/12 (Timoshenko); what is left
    // out falls with the square of h/R.
    let (radius, force) = (50.0_f64, 10.0);
    for height in [2.0_f64, 4.0] {
        let [inner, outer] = [radius - 0.5 * height, radius + 0.5 * height];
        let shape = format!(
            "{{ ring = {{ centre = [0, {outer}], inner = {inner}, outer = {outer}, sweep = 90, contact = \"outer\" }} \
            }}"
        );
        let face = format!("[{{ rigid-face = {{ at = \"end\", component = \"y\", force = {} }} }}]", -0.5 * force);
        let gap = format!("{{ circle = {outer} }}");
        let per = "0.1\ngrowth = { along = 1.4, depth = 1.4, coarsest = 0.05 }";
        let keys = [("plane", "\"stress\""), ("shape", &shape), ("supports", START), ("loads", &face)];
        let (_, meshed, run) = solved(&ring(&[&keys[..], &[("gap", &gap), ("stretch", "0.3"), ("per", per)]].concat()));
        let bending = 210e3 * height.powi(3) / 12.0;
        let wanted = 0.5 * force * radius.powi(3) * (FRAC_PI_4 - FRAC_2_PI) / bending;
        let found = approach(&meshed, &run);
        assert!((found / wanted - 1.0).abs() <= 3.0 * (height / radius).powi(2), "{height}: {found}, {wanted}");
        assert_relative_eq!(run.contacts[0].transmitted, force, max_relative = 1e-6);
    }
}

#[test]
fn ring_on_a_flat_is_the_same_however_it_is_modelled() {
    let on_block =
        ring(&[]).replace("[contact]\n", BLOCK).replace("first = \"body\"\n", "first = \"body\"\nsecond = \"block\"\n");
    let wanted = numbers(&on_block);
    let both = on_block
        .replace(ON_START, "{ at = \"end\", component = \"x\" }")
        .replace("x = [0, 60]", "x = [-60, 60]")
        .replace("at = \"left\"", "at = [0, -60]")
        .replace("stretch = 3", "stretch = 3\nboth-sides = true");
    let swapped = on_block.replace("first = \"body\"\nsecond = \"block\"", "first = \"block\"\nsecond = \"body\"");
    let drawn = on_block.replace("{ circle = 50 }", "{ from = \"bodies\" }");
    for (what, text) in [("both sides", both), ("swapped", swapped), ("from the bodies", drawn)] {
        assert_alike(numbers(&text), wanted, 1e-6, what);
    }

    // Half a tube, all of it, and its pressure over the bore: statics give the resultant.
    let load =
        "[{ traction = { at = \"inner\", part = { centre = [0, 50], from = 0, to = 20 }, force = [0, -1000] } }]";
    let right = ring(&[("loads", load)]).replace("sweep = 90", "sweep = 180");
    let whole = right
        .replace("from = 0", "from = -20")
        .replace("-1000", "-2000")
        .replace(ON_START, TWO_POINTS)
        .replace("stretch = 3", "stretch = 3\nboth-sides = true");
    let wanted = numbers(&right);
    assert_relative_eq!(wanted[2], 2000.0, max_relative = 1e-8);
    assert_alike(numbers(&whole), wanted, 1e-6, "all of a tube");
}

#[test]
fn pressure_on_a_part_of_a_bore_in_centimetres_is_carried_by_the_contact() {
    // 50 MPa on 30° on both sides of a bore of 80 mm, 10 mm thick: 2 p r t sin 30°.
    let [peak, width, resultant] = numbers(&balance::text("tube-on-plane"));
    assert_relative_eq!(resultant, 2.0 * 50.0 * 80.0 * 10.0 * 0.5, max_relative = 2e-6);
    // As the same tube whose lengths are in millimetres.
    let lengths = [("length", "\"mm\""), ("thickness", "10"), ("stretch", "10"), ("per", "3")];
    let millimetres =
        lengths.iter().fold(balance::text("tube-on-plane"), |text, (key, value)| with_key(&text, key, value));
    let centre = millimetres.replace("[0, 15]", "[0, 150]").replace("inner = 8, outer = 15", "inner = 80, outer = 150");
    let other = numbers(&centre.replace("circle = 15", "circle = 150"));
    assert_alike([peak, width, resultant], other, 1e-9, "in centimetres");
}

#[test]
fn ring_on_a_flat_takes_every_option_and_its_own_answer_is_met() {
    let folder = Folder::made();
    let (at, file) = (|name: &str| folder.at(name), folder.with("ring.toml", ring(&[])));
    for option in [["--fitted", "--force"], ["--accuracy", "0.5 %"], ["--order", "5"]] {
        let (passed, text, error) = contact_vv(&[&["solve", &file, "--all"][..], &option[..]].concat());
        assert!(passed && text.contains("resultant 2000.0"), "{option:?}: {text}{error}");
        let peak = text.lines().find(|line| line.contains("peak-pressure ")).expect("a bar").to_owned();
        assert!(!peak.contains("unknown"), "{option:?}: {peak}");
    }
    let [vtu, csv] = ["ring.vtu", "ring.csv"].map(at);
    assert!(contact_vv(&["solve", &file, "--vtu", &vtu, "--csv", &csv, "--plot", &at("ring.svg")]).0);
    let (met, text, error) = contact_vv(&[&["judge", &file, &vtu, &csv][..], &UNITS].concat());
    assert!(met, "{text}{error}");
}

/// Angles of a ring's mesh from −π on, finer towards the lowest point: two for every cell.
const ANGLES: usize = 128;
/// Positions across it.
const ACROSS: usize = 24;

/// A ring of radii 30 and 50 on y = 0; its rim, or the part up to an angle, is one physical curve, its bore another.
fn gmsh(order: usize, clockwise: bool, rim_up_to: f64) -> Vec<u8> {
    let angle = |k: usize| {
        let t = 2.0 * k as f64 / ANGLES as f64 - 1.0;
        PI * t * (0.06 + 0.94 * t.abs().powf(1.5))
    };
    let tag = |row: usize, k: usize| (1 + row * ANGLES + k % ANGLES) as u64;
    let node = |row: usize, k: usize| {
        let radius = 50.0 - 20.0 * (row as f64 / ACROSS as f64).powf(1.6);
        (tag(row, k), [radius * angle(k).sin(), 50.0 - radius * angle(k).cos()])
    };
    let nodes = (0..=ACROSS).flat_map(|row| (0..ANGLES).map(move |k| node(row, k))).collect();
    let cell = |row: usize, k: usize| {
        let corners = [tag(row, k), tag(row, k + 2), tag(row + 2, k + 2), tag(row + 2, k)];
        let middles = [tag(row, k + 1), tag(row + 1, k + 2), tag(row + 2, k + 1), tag(row + 1, k)];
        let turned = |of: [u64; 4], by: [usize; 4]| if clockwise { by.map(|k| of[k]) } else { of };
        [turned(corners, [0, 3, 2, 1]), turned(middles, [3, 2, 1, 0])].concat()[..4 * order].to_vec()
    };
    let angles = || (0..ANGLES).step_by(2);
    let cells = angles().flat_map(|k| (0..ACROSS).step_by(2).map(move |row| cell(row, k)));
    let cells = cells.enumerate().map(|(number, nodes)| (number as u64 + 1, nodes)).collect();
    let edge = |row: usize, ends: [usize; 2]| {
        [ends[0], ends[1], ends[0].min(ends[1]) + 1].map(|k| tag(row, k))[..=order].to_vec()
    };
    let within = |k: &usize| angle(*k).abs().max(angle(*k + 2).abs()) <= rim_up_to * (1.0 + 1e-9);
    let rim = angles().filter(within).map(|k| edge(0, if clockwise { [k + 2, k] } else { [k, k + 2] }));
    let bore = angles().map(|k| edge(ACROSS, [k + 2, k]));
    let sides = vec![("rim", rim.collect()), ("bore", bore.collect())];
    msh(&Body { nodes, cells, sides }, "4.1", Coding::Text)
}

/// A Gmsh ring on y = 0, pushed down at its bore.
fn closed() -> String {
    ring(&[
        ("shape", "{ gmsh = { file = \"ring.msh\", group = \"body\", contact = \"rim\" } }"),
        ("supports", &format!("[{TWO_POINTS}]")),
        ("loads", "[{ traction = { at = \"bore\", value = [0, -20] } }]"),
        ("stretch", "6\nboth-sides = true"),
    ])
    .replace("elements = 8\nper = 1\n", "")
}

/// A scene beside a mesh.
fn beside(mesh: Vec<u8>, text: &str) -> Result<Case, Error> {
    let folder = Folder::made();
    folder.with("ring.msh", mesh);
    Case::parse(&folder.path().join("scene.toml"), text)
}

#[test]
fn closed_rim_of_a_gmsh_mesh_is_used_where_it_faces_the_flat() {
    let solved = |mesh: Vec<u8>, text: &str| {
        let case = beside(mesh, text).unwrap_or_else(|error| panic!("{error}"));
        case.solve().unwrap_or_else(|error| panic!("{error}"))
    };
    for order in [1, 2] {
        let (_, part) = solved(gmsh(order, false, FRAC_PI_2), &closed());
        for clockwise in [false, true] {
            let (meshed, run) = solved(gmsh(order, clockwise, PI), &closed());
            assert_alike(of_run(&run), of_run(&part), 1e-9, "the lower half of the rim alone");
            let mesh = &meshed.discretisation.mesh;
            let heights = mesh.bodies[0].candidates.iter().map(|candidate| mesh.points[candidate.node][1]);
            assert!(heights.fold(0.0, f64::max) < 1.0, "candidates at the top");
            // The top, 100 mm above, is no part of what penetrates: what 4-node edges pass over is the same as of the
            // lower half.
            let deepest = |run: &Run| run.solution.unseen[0].iter().map(|one| one.penetration).fold(0.0, f64::max);
            assert_relative_eq!(deepest(&run), deepest(&part), epsilon = 1e-9);
        }
    }
    // And as the same ring meshed here, on cells of other sizes.
    let (_, of_order_2) = solved(gmsh(2, false, PI), &closed());
    let load = ("loads", "[{ traction = { at = \"inner\", value = [0, -20] } }]");
    let supports = format!("[{TWO_POINTS}]");
    let own = ring(&[load, ("supports", &supports), ("stretch", "6\nboth-sides = true")]);
    let own = numbers(&own.replace("sweep = 90", "sweep = 180"));
    assert_alike(of_run(&of_order_2), own, 0.02, "the ring meshed here");
}

#[test]
fn closed_boundaries_that_face_nothing_are_refused_with_a_remedy() {
    for (was, is, found, remedy) in [
        ("both-sides = true\n", "", "does not begin on the symmetry line x = 0", "`both-sides = true`"),
        ("stretch = 6", "stretch = 40", "slopes by", "end the `stretch` where it is flatter"),
        ("stretch = 6", "stretch = 60", "does not look one way", "end the stretch where it turns away"),
        ("contact = \"rim\"", "contact = \"bore\"", "does not begin at y = 0", "move the body there"),
        ("both-sides", "origin = [0, 20]\nboth-sides", "does not begin at y = 20", "give its `origin`"),
        ("circle = 50", "circle = 80", "the gap is 0.225", "`gap = { from = \"bodies\" }`"),
    ] {
        refused(beside(gmsh(2, false, PI), &closed().replace(was, is)), &["scene.toml:", found, remedy]);
    }
}

/// A disc and a block, each pushed towards the other by displacements: the disc down, the block up \[mm\].
fn pushed(gap: &str, height: f64, [down, up]: [f64; 2]) -> String {
    balance::text("disc-above-block")
        .replace("circle = 50, clearance = 0.02", gap)
        .replace("[0, 50.02]", &format!("[0, {height}]"))
        .replace("-0.03", &format!("{}", -down))
        .replace("0.05 }]", &format!("{up} }}]"))
}

/// The disc pressed by a load instead.
fn loaded(gap: &str) -> String {
    let text = pushed(gap, 50.0, [0.0, 0.0]).replace(", { at = \"cut\", component = \"y\", value = -0 }", "");
    text.replacen("loads = []", "loads = [{ traction = { at = \"cut\", value = [0, -20] } }]", 1)
}

#[test]
fn clearance_beside_a_profile_is_closed_before_bodies_are_pressed() {
    let (_, meshed, run) = solved(&pushed("circle = 50, clearance = 0.02", 50.02, [0.03, 0.05]));
    assert_relative_eq!(approach(&meshed, &run), 0.08, max_relative = 1e-9);
    let found = of_run(&run);
    for (what, text) in [
        ("drawn touching", pushed("circle = 50, clearance = 0.02", 50.0, [0.03, 0.05])),
        ("no clearance, pushed less", pushed("circle = 50", 50.0, [0.01, 0.05])),
        ("as drawn", pushed("from = \"bodies\"", 50.02, [0.03, 0.05])),
    ] {
        assert_alike(numbers(&text), found, 1e-6, what);
    }
    let lifted = "table = [[0, 0.02], [1, 0.030001], [3, 0.110081]], smooth = true";
    let beside = "table = [[0, 0], [1, 0.010001], [3, 0.090081]], smooth = true, clearance = 0.02";
    let [lifted, beside] = [lifted, beside]
        .map(|gap| numbers(&pushed(gap, 50.0, [0.03, 0.05]).replace("stretch = 3", "stretch = 3\ngap-only = true")));
    assert_alike(lifted, beside, 1e-9, "a table that begins with it");

    // A load closes any clearance: the contact is that without one, and the body has moved farther by it.
    let [(free, through), (touching, own)] = ["circle = 50, clearance = 0.5", "circle = 50"].map(|gap| {
        let (_, meshed, run) = solved(&loaded(gap));
        (of_run(&run), approach(&meshed, &run))
    });
    assert_alike(free, touching, 1e-6, "a load");
    assert_relative_eq!(through - own, 0.5, max_relative = 1e-8);

    // A push that does not close it presses nothing, and no algorithm takes it for an interference.
    let open = solved(&pushed("circle = 50, clearance = 0.02", 50.0, [0.01, 0.005])).2;
    assert!(open.contacts[0].transmitted.abs() <= 0.0 && open.contacts[0].measures.stretches.is_empty());
    let varying = pushed("circle = 50, clearance = 0.02", 50.0, [0.03, 0.05]) + "[solve]\nalgorithm = \"varying\"\n";
    assert_alike(numbers(&varying), found, 5e-3, "varying stiffness");
}

#[test]
fn clearance_is_told_wherever_a_gap_is_told() {
    // Half of it carries 20 MPa on 50 mm.
    let hertz = "stretch = 3\noracle = { hertz = { load = 2000, radius = 50 } }";
    let text = loaded("circle = 50, clearance = 0.02").replace("stretch = 3", hertz);
    let (case, meshed, _) = solved(&text);
    let pair = case.scene.contact();
    assert_relative_eq!(pair.gap(1.0), 50.0 - (2500.0_f64 - 1.0).sqrt() + 0.02, max_relative = 1e-12);
    assert_relative_eq!(case.scene.in_metres().contact().gap(1e-3), 1e-3 * pair.gap(1.0), max_relative = 1e-12);
    assert!(meshed.discretisation.interfaces[0].nodes.iter().all(|node| node.gap >= 0.02));

    let folder = Folder::made();
    let (file, exported) = (folder.with("scene.toml", text), folder.at("exported"));
    assert!(contact_vv(&["export", &file, &exported]).0);
    let sheet = folder.read("exported/scene.md");
    assert!(sheet.contains("R = 50, and 0.02 more everywhere"), "{sheet}");
    let problem: serde_json::Value = serde_json::from_str(&folder.read("exported/problem.json")).expect("JSON");
    assert_relative_eq!(problem["contacts"][0]["nodes"][0]["gap"].as_f64().expect("a gap"), 0.02, max_relative = 1e-12);
    assert!(contact_vv(&["judge", &file, &format!("{exported}/ours.csv")]).0);
}

#[test]
fn waves_that_are_pressed_flat_go_on_from_those_that_are_not() {
    let open = Waves { modulus: 210e3 / 0.91, amplitude: 0.01, wavelength: 40.0, mean: 0.0 };
    let of = |share: f64| Waves { mean: share * open.complete(), ..open };
    let numbers = |waves: Waves| {
        let pressures = [0.0, 3.0, 11.0, 19.0, 23.0].map(|x| waves.pressure(x) / waves.complete());
        [[waves.half_width(), waves.second_moment(), waves.sunk() / waves.amplitude].as_slice(), &pressures].concat()
    };
    let ([below, at], above) = ([1.0 - 1e-10, 1.0].map(|share| numbers(of(share))), numbers(of(1.0 + 1e-10)));
    for k in 0..at.len() {
        // Half-width and pressure end in a root.
        assert!(
            (below[k] - at[k]).abs() <= 2e-4 && (above[k] - at[k]).abs() <= 1e-8,
            "{k}: {below:?} {at:?} {above:?}"
        );
    }
    let waves = of(1.7);
    let [mean, complete] = [waves.mean, waves.complete()];
    let wave = |x: f64| mean + complete * (2.0 * PI * x / 40.0).cos();
    assert_relative_eq!(waves.half_width(), 20.0, max_relative = 1e-12);
    for x in [0.0, 4.0, 10.0, 20.0, 31.0] {
        assert_relative_eq!(waves.pressure(x), wave(x), max_relative = 1e-12);
    }
    let points = (0..4000).map(|k| -20.0 + (f64::from(k) + 0.5) / 100.0);
    let moments =
        points.map(|x| [wave(x), wave(x) * x * x]).fold([0.0; 2], |sum, term| [sum[0] + term[0], sum[1] + term[1]]);
    assert_relative_eq!(waves.second_moment(), 2.0 * (moments[1] / moments[0]).sqrt(), max_relative = 1e-6);
    assert_relative_eq!(waves.sunk(), waves.amplitude, max_relative = 1e-12);
}

#[test]
fn block_that_is_pressed_flat_on_waves_has_their_pressure() {
    let text = text_of("rigid-cosine.toml").replace("stretch = 16", "stretch = 20");
    let text = text.replace("-62.618859641", "-300").replace("2504.75438564", "12000").replace("2504.754386", "12000");
    let (case, meshed, run) = solved(&text);
    for judged in case.judge(&meshed, &run).expect("judged") {
        assert_eq!(judged.verdict, Verdict::Pass, "{}: {:e}", judged.check.quantity, judged.error);
    }
    let waves = Waves { modulus: 210e3 / 0.91, amplitude: 0.01, wavelength: 40.0, mean: 300.0 };
    assert_relative_eq!(run.measures().peak.pressure, waves.mean + waves.complete(), max_relative = 5e-4);
    assert_relative_eq!(run.measures().half_width(), 20.0, max_relative = 1e-9);
    // Flattened waves leave the block's own shortening under the mean pressure, and their height.
    let shortening = 300.0 * 40.0 * (1.0 + 0.3) * (1.0 - 2.0 * 0.3) / (210e3 * (1.0 - 0.3));
    assert_relative_eq!(approach(&meshed, &run), shortening + waves.sunk(), max_relative = 2e-3);
}

#[test]
fn half_a_tube_is_in_contact_where_it_faces_the_other_body_alone() {
    let held = ", { at = \"end\", component = \"x\" }";
    let [half, most] = [&[][..], &[["sweep = 180", "sweep = 135"], [held, ""]]]
        .map(|changes| of_run(&balance::scene("disc-in-half-tube", changes).solve().expect("solved").1));
    assert_alike(half, most, 2e-3, "three quarters of it");
    assert!((half[0] / 700.86 - 1.0).abs() < 2e-3, "{half:?}");
}

/// The file with the force on a half, and mesh and stretch for the contact that Hertz gives there, times `times` its
/// own.
fn under(times: f64) -> String {
    let root = times.sqrt();
    let [force, stretch, per] = [
        format!("force = [0, {}]", 0.32955 * times),
        format!("stretch = {}", 2.0 * root),
        format!("per = {}", 0.2 * root),
    ];
    changed(
        &text_of("rigid-pin.toml"),
        &[("force = [0, 0.32955]", &force), ("stretch = 2", &stretch), ("per = 0.2", &per)],
    )
}

#[test]
fn gap_of_a_pin_is_the_distance_along_the_radius_of_the_hole() {
    for (radius, clearance) in [(10.0, 0.01), (10.0, 3.0), (7.0, 1e-7)] {
        let pin = Circle { centre: [0.0, -clearance], radius };
        for angle in [0.0, 1e-3, 0.3, 1.0, 1.5] {
            let gap = Profile::Pin { radius, clearance }.gap(angle);
            assert_relative_eq!(gap, radius + clearance - pin.along_ray([0.0, 0.0], angle), epsilon = 1e-14);
        }
    }
}

#[test]
fn rigid_pin_comes_to_hertz_as_its_angle_falls() {
    let (load, radius) = (0.6591, 10.0 * 10.01 / 0.01);
    let errors = [0.25, 1.0, 4.0].map(|times: f64| {
        let run = solved(&under(times)).2;
        assert_relative_eq!(run.transmitted(), times * load, max_relative = 1e-8);
        // p0 = √(P E*/(π R)), E* that of the plate alone: E in plane stress.
        let hertz = (times * load * 210e3 / (PI * radius)).sqrt();
        1.0 - run.measures().peak.pressure / hertz
    });
    let [quarter, whole, fourfold] = errors;
    assert!(fourfold.abs() <= 0.007 && whole.abs() <= 0.004 && quarter.abs() <= 0.002, "{errors:?}");
    // What Hertz leaves out goes with the angle, and that with the root of the load.
    for ratio in [fourfold / whole, whole / quarter] {
        assert!((1.6..=2.4).contains(&ratio), "{errors:?}");
    }
}

#[test]
fn very_stiff_pin_is_a_rigid_one() {
    let pin = "[[body]]\nname = \"pin\"\nyoung = 210e8\npoisson = 0.3\n\
               shape = { disc = { centre = [0, -0.01], radius = 10, half = true } }\n\
               supports = [{ at = \"axis\", component = \"x\" }, { at = \"middle\", component = \"y\" \
               }]\n\n[contact]\n";
    let rigid = solved(&text_of("rigid-pin.toml")).2;
    let stiff = |young: &str| {
        let second = "first = \"plate\"\nsecond = \"pin\"";
        solved(&changed(
            &text_of("rigid-pin.toml"),
            &[("[contact]\n", &pin.replace("210e8", young)), ("first = \"plate\"", second)],
        ))
        .2
    };
    let (near, far) = (stiff("210e8"), stiff("210e3"));
    let [wanted, found] = [&rigid, &near].map(|run| run.measures());
    assert_relative_eq!(found.peak.pressure, wanted.peak.pressure, max_relative = 1e-4);
    assert_relative_eq!(found.second_moment_width, wanted.second_moment_width, max_relative = 1e-4);
    // And one of the plate's own material is not: about √2 wider.
    assert!(far.measures().second_moment_width > 1.3 * wanted.second_moment_width);
}
