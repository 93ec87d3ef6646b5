//! Rings on flats, closed boundaries of Gmsh meshes, clearances beside profiles, and waves that are pressed flat.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};
use std::fmt::Write;
use std::path::Path;

use approx::assert_relative_eq;
use contact_vv::case::{Case, Meshed, Verdict};
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::oracle::analytic::waves::Waves;
use contact_vv::oracle::{Oracle, Quantity, Reading};
use contact_vv::solve::Run;

use crate::outputs::contact_vv;
use crate::scene_file::text_of;

/// A body on y = 0 under vertical forces, and what is changed of it.
fn scene(shape: &str, supports: &str, loads: &str, contact: &str, mesh: &str) -> String {
    format!(
        "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"body\"\nyoung = 210e3\npoisson = 0.3\nshape = {{ {shape} }}\n\
         supports = [{supports}]\nloads = [{loads}]\n[contact]\nfirst = \"body\"\n{contact}\n[mesh]\n{mesh}\n"
    )
}

const BLOCK: &str = "[[body]]\nname = \"block\"\nyoung = 70e3\npoisson = 0.3\n\
    shape = { rectangle = { x = [0, 60], y = [-60, 0], contact = \"top\" } }\n\
    supports = [{ at = \"left\", component = \"x\" }, { at = \"far\", component = \"y\" }]\n[contact]\n";
const RING: &str = "ring = { centre = [0, 50], inner = 30, outer = 50, sweep = 90, contact = \"outer\" }";
const ON_START: &str = "{ at = \"start\", component = \"x\" }, { at = \"end\", component = \"x\" }";
const PRESSED: &str = "{ traction = { at = \"end\", value = [0, -50] } }";
const FLAT: &str = "gap = { circle = 50 }\nstretch = 3";
const FINE: &str = "elements = 8\nper = 1";

fn ring() -> String {
    scene(RING, ON_START, PRESSED, FLAT, FINE)
}

fn read(text: &str) -> Result<Case, String> {
    read_in(Path::new(""), text)
}

fn read_in(folder: &Path, text: &str) -> Result<Case, String> {
    Case::parse(&folder.join("scene.toml"), text).map_err(|error| error.to_string())
}

fn solved(text: &str) -> (Case, Meshed, Run) {
    let case = read(text).unwrap_or_else(|error| panic!("{error}"));
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
    let (mesh, contact) = ("elements = 16\nper = 0.9", "gap = { circle = 50 }\nstretch = 1.8");
    let thick = RING.replace("inner = 30", "inner = 2");
    let start = "{ at = \"start\", component = \"x\" }";
    let load = |at: &str, traction: f64| format!("{{ traction = {{ at = \"{at}\", value = [0, {traction}] }} }}");
    let ring = numbers(&scene(&thick, start, &load("end", -30.0 * 50.0 / 48.0), contact, mesh));
    let axis = "{ at = \"axis\", component = \"x\" }";
    let disc = numbers(&scene("disc = { centre = [0, 50], radius = 50 }", axis, &load("cut", -30.0), contact, mesh));
    let hertz = Hertz { load: 3000.0, radius: 50.0, modulus: 210e3 / 0.91 };
    let of = |quantity| match hertz.read(&quantity) {
        Reading::Value { value, .. } => value,
        other => panic!("{other:?}"),
    };
    let wanted = [of(Quantity::PeakPressure), of(Quantity::HalfWidth), 3000.0];
    assert_alike(ring, wanted, 1.5e-3, "Hertz");
    assert_alike(ring, disc, 2e-4, "a disc");
}

#[test]
fn thin_ring_on_a_flat_gives_way_as_a_curved_beam() {
    // Half of the diametral compression under two forces P, `P R³ (π/4 − 2/π)/EI`, I = h³/12 (Timoshenko); what is left out falls
    // with the square of h/R.
    let (radius, force) = (50.0_f64, 10.0);
    for height in [2.0_f64, 4.0] {
        let [inner, outer] = [radius - 0.5 * height, radius + 0.5 * height];
        let shape = format!(
            "ring = {{ centre = [0, {outer}], inner = {inner}, outer = {outer}, sweep = 90, contact = \"outer\" }}"
        );
        let face = format!("{{ rigid-face = {{ at = \"end\", component = \"y\", force = {} }} }}", -0.5 * force);
        let mesh = "elements = 8\nper = 0.1\ngrowth = { along = 1.4, depth = 1.4, coarsest = 0.05 }";
        let contact = format!("gap = {{ circle = {outer} }}\nstretch = 0.3");
        let text = scene(&shape, "{ at = \"start\", component = \"x\" }", &face, &contact, mesh);
        let (_, meshed, run) = solved(&text.replace("strain", "stress"));
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
        ring().replace("[contact]\n", BLOCK).replace("first = \"body\"\n", "first = \"body\"\nsecond = \"block\"\n");
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
    let half = RING.replace("sweep = 90", "sweep = 180");
    let load = "{ traction = { at = \"inner\", part = { centre = [0, 50], from = 0, to = 20 }, force = [0, -1000] } }";
    let right = scene(&half, ON_START, load, FLAT, FINE);
    let whole = right
        .replace("from = 0", "from = -20")
        .replace("-1000", "-2000")
        .replace(ON_START, "{ at = [0, 20], component = \"x\" }, { at = [0, 80], component = \"x\" }")
        .replace("stretch = 3", "stretch = 3\nboth-sides = true");
    let wanted = numbers(&right);
    assert_relative_eq!(wanted[2], 2000.0, max_relative = 1e-8);
    assert_alike(numbers(&whole), wanted, 1e-6, "all of a tube");
}

#[test]
fn ring_on_a_flat_takes_every_option_and_its_own_answer_is_met() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    std::fs::write(folder.path().join("ring.toml"), ring()).expect("written");
    for option in [["--fitted", "--force"], ["--accuracy", "0.5 %"], ["--order", "5"]] {
        let (passed, text, error) = contact_vv(&[&["solve", &at("ring.toml"), "--all"][..], &option[..]].concat());
        assert!(passed && text.contains("resultant 2000.0"), "{option:?}: {text}{error}");
        let peak = text.lines().find(|line| line.contains("peak-pressure ")).expect("a bar").to_owned();
        assert!(!peak.contains("unknown"), "{option:?}: {peak}");
    }
    let (vtu, exported) = (at("ring.vtu"), at("exported"));
    assert!(contact_vv(&["solve", &at("ring.toml"), "--vtu", &vtu, "--plot", &at("ring.svg")]).0);
    assert!(contact_vv(&["export", &at("ring.toml"), &exported]).0);
    let units = ["position", "pressure", "gap", "displacement"]
        .map(|role| format!("{role}={}", if role == "pressure" { "MPa" } else { "mm" }));
    let units: Vec<&str> = units.iter().flat_map(|unit| ["--unit", unit]).collect();
    for (answer, options) in [(vtu, &units[..]), (format!("{exported}/ours.csv"), &[])] {
        let (met, text, error) = contact_vv(&[&["judge", &at("ring.toml"), &answer][..], options].concat());
        assert!(met, "{answer}: {text}{error}");
    }
}

/// Angles of a ring's mesh from −π on, finer towards the lowest point: two for every cell.
const ANGLES: usize = 128;
/// Positions across it.
const ACROSS: usize = 24;

/// A ring of radii 30 and 50 on y = 0; its rim, or the part up to an angle, is one physical curve, its bore another.
fn gmsh(order: usize, clockwise: bool, rim_up_to: f64) -> String {
    let angle = |k: usize| {
        let t = 2.0 * k as f64 / ANGLES as f64 - 1.0;
        PI * t * (0.06 + 0.94 * t.abs().powf(1.5))
    };
    let tag = |row: usize, k: usize| 1 + row * ANGLES + k % ANGLES;
    let mut nodes = (String::new(), String::new());
    for row in 0..=ACROSS {
        for k in 0..ANGLES {
            let radius = 50.0 - 20.0 * (row as f64 / ACROSS as f64).powf(1.6);
            writeln!(nodes.0, "{}", tag(row, k)).expect("written");
            writeln!(nodes.1, "{} {} 0", radius * angle(k).sin(), 50.0 - radius * angle(k).cos()).expect("written");
        }
    }
    let (mut rim, mut bore, mut cells) = (Vec::new(), Vec::new(), Vec::new());
    for k in (0..ANGLES).step_by(2) {
        if angle(k).abs().max(angle(k + 2).abs()) <= rim_up_to * (1.0 + 1e-9) {
            rim.push([tag(0, k), tag(0, k + 2), tag(0, k + 1)]);
        }
        bore.push([tag(ACROSS, k + 2), tag(ACROSS, k), tag(ACROSS, k + 1)]);
        for row in (0..ACROSS).step_by(2) {
            let corners = [tag(row, k), tag(row, k + 2), tag(row + 2, k + 2), tag(row + 2, k)];
            let middles = [tag(row, k + 1), tag(row + 1, k + 2), tag(row + 2, k + 1), tag(row + 1, k)];
            let turned = |of: [usize; 4], by: [usize; 4]| if clockwise { by.map(|k| of[k]) } else { of };
            cells.push([turned(corners, [0, 3, 2, 1]), turned(middles, [3, 2, 1, 0])].concat());
        }
    }
    if clockwise {
        rim.iter_mut().for_each(|edge| edge.swap(0, 1));
    }
    let [edge, cell] = [[1, 3], [8, 16]][order - 1];
    let mut number = 0;
    let mut block = |head: String, all: &mut dyn Iterator<Item = &[usize]>, nodes: usize| {
        let lines = all.map(|one| {
            number += 1;
            let tags: Vec<String> = one[..nodes].iter().map(usize::to_string).collect();
            format!("{number} {}\n", tags.join(" "))
        });
        head + &lines.collect::<String>()
    };
    let blocks = [
        block(format!("1 1 {edge} {}\n", rim.len()), &mut rim.iter().map(|one| &one[..]), order + 1),
        block(format!("1 2 {edge} {}\n", bore.len()), &mut bore.iter().map(|one| &one[..]), order + 1),
        block(format!("2 1 {cell} {}\n", cells.len()), &mut cells.iter().map(|one| &one[..]), 4 * order),
    ];
    let (count, all) = (ANGLES * (ACROSS + 1), rim.len() + bore.len() + cells.len());
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"rim\"\n1 2 \"bore\"\n2 3 \"ring\"\n$EndPhysicalNames\n\
         $Entities\n0 2 1 0\n1 -50 0 0 50 100 0 1 1 0\n2 -30 20 0 30 80 0 1 2 0\n1 -50 0 0 50 100 0 1 3 2 1 2\n$EndEntities\n\
         $Nodes\n1 {count} 1 {count}\n2 1 0 {count}\n{}{}$EndNodes\n$Elements\n3 {all} 1 {all}\n{}$EndElements\n",
        nodes.0,
        nodes.1,
        blocks.concat()
    )
}

/// A Gmsh ring on y = 0, pushed down at its bore.
fn closed() -> String {
    let shape = "gmsh = { file = \"ring.msh\", group = \"ring\", contact = \"rim\" }";
    let supports = "{ at = [0, 20], component = \"x\" }, { at = [0, 80], component = \"x\" }";
    let load = "{ traction = { at = \"bore\", value = [0, -20] } }";
    scene(shape, supports, load, "gap = { circle = 50 }\nboth-sides = true\nstretch = 6", "")
}

#[test]
fn closed_rim_of_a_gmsh_mesh_is_used_where_it_faces_the_flat() {
    let folder = tempfile::tempdir().expect("a folder");
    let solved = |mesh: String, text: &str| {
        std::fs::write(folder.path().join("ring.msh"), mesh).expect("written");
        let case = read_in(folder.path(), text).unwrap_or_else(|error| panic!("{error}"));
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
            // The top, 100 mm above, is no part of what penetrates: what 4-node edges pass over is the same as of the lower half.
            let deepest = |run: &Run| run.solution.unseen[0].iter().map(|one| one.penetration).fold(0.0, f64::max);
            assert_relative_eq!(deepest(&run), deepest(&part), epsilon = 1e-9);
        }
    }
    // And as the same ring meshed here, on cells of other sizes.
    let (_, of_order_2) = solved(gmsh(2, false, PI), &closed());
    let meshed_here = RING.replace("sweep = 90", "sweep = 180");
    let load = "{ traction = { at = \"inner\", value = [0, -20] } }";
    let supports = "{ at = [0, 20], component = \"x\" }, { at = [0, 80], component = \"x\" }";
    let contact = "gap = { circle = 50 }\nboth-sides = true\nstretch = 6";
    let own = numbers(&scene(&meshed_here, supports, load, contact, FINE));
    assert_alike(of_run(&of_order_2), own, 0.02, "the ring meshed here");
}

#[test]
fn closed_boundaries_that_face_nothing_are_refused_with_a_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("ring.msh"), gmsh(2, false, PI)).expect("written");
    for (was, is, found, remedy) in [
        ("both-sides = true\n", "", "does not begin on the symmetry line x = 0", "`both-sides = true`"),
        ("stretch = 6", "stretch = 40", "slopes by", "end the `stretch` where it is flatter"),
        ("stretch = 6", "stretch = 60", "does not look one way", "end the stretch where it turns away"),
        ("contact = \"rim\"", "contact = \"bore\"", "does not begin at y = 0", "move the body there"),
        ("both-sides", "origin = [0, 20]\nboth-sides", "does not begin at y = 20", "give its `origin`"),
        ("circle = 50", "circle = 80", "the gap is 0.225", "`gap = { from = \"bodies\" }`"),
    ] {
        let error = read_in(folder.path(), &closed().replace(was, is)).map(|_| ()).expect_err(is);
        assert!(error.contains("scene.toml:") && error.contains(found) && error.contains(remedy), "{is}: {error}");
    }
}

/// A disc and a block, each pushed towards the other by displacements: the disc down, the block up \[mm\].
fn pushed(gap: &str, height: f64, [down, up]: [f64; 2]) -> String {
    let disc = format!("disc = {{ centre = [0, {height}], radius = 50 }}");
    let supports =
        format!("{{ at = \"axis\", component = \"x\" }}, {{ at = \"cut\", component = \"y\", value = {} }}", -down);
    let text = scene(&disc, &supports, "", &format!("second = \"block\"\ngap = {{ {gap} }}\nstretch = 3"), FINE);
    let block = BLOCK.replace("\"far\", component = \"y\"", &format!("\"far\", component = \"y\", value = {up}"));
    text.replace("[contact]\n", &block)
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
    let loaded = |gap: &str| {
        let text = pushed(gap, 50.0, [0.0, 0.0]);
        let text = text.replace(", { at = \"cut\", component = \"y\", value = -0 }", "");
        let (_, meshed, run) =
            solved(&text.replacen("loads = []", "loads = [{ traction = { at = \"cut\", value = [0, -20] } }]", 1));
        (of_run(&run), approach(&meshed, &run))
    };
    let ((free, through), (touching, own)) = (loaded("circle = 50, clearance = 0.5"), loaded("circle = 50"));
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
    let text = pushed("circle = 50, clearance = 0.02", 50.0, [0.03, 0.05]);
    let (case, meshed, _) = solved(&text);
    let pair = case.scene.contact();
    assert_relative_eq!(pair.gap(1.0), 50.0 - (2500.0_f64 - 1.0).sqrt() + 0.02, max_relative = 1e-12);
    assert_relative_eq!(case.scene.in_metres().contact().gap(1e-3), 1e-3 * pair.gap(1.0), max_relative = 1e-12);
    assert!(meshed.discretisation.interfaces[0].nodes.iter().all(|node| node.gap >= 0.02));

    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.toml").to_string_lossy().into_owned();
    let exported = folder.path().join("exported").to_string_lossy().into_owned();
    std::fs::write(&file, text).expect("written");
    assert!(contact_vv(&["export", &file, &exported]).0);
    let sheet = std::fs::read_to_string(folder.path().join("exported/scene.md")).expect("a sheet");
    assert!(sheet.contains("R = 50, and 0.02 more everywhere"), "{sheet}");
    let problem = std::fs::read_to_string(folder.path().join("exported/problem.json")).expect("a problem");
    let problem: serde_json::Value = serde_json::from_str(&problem).expect("JSON");
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
    let bodies = |sweep: f64| {
        format!(
            "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"tube\"\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ ring = {{ centre = [0, 50], inner = 30, outer = 50, sweep = {sweep}, contact = \"inner\" }} }}\n\
             supports = [{{ at = \"start\", component = \"x\" }}, {{ at = \"outer\", component = \"y\" }}{}]\n\
             [[body]]\nname = \"disc\"\nyoung = 210e3\npoisson = 0.3\n\
             shape = {{ disc = {{ centre = [0, 45], radius = 25 }} }}\n\
             supports = [{{ at = \"axis\", component = \"x\" }}]\n\
             loads = [{{ traction = {{ at = \"cut\", value = [0, -40] }} }}]\n\
             [contact]\nfirst = \"disc\"\nsecond = \"tube\"\ngap = {{ circles = [25, -30] }}\nstretch = 4\norigin = [0, 20]\n\
             [mesh]\nelements = 8\nper = 1\n",
            if sweep == 180.0 { ", { at = \"end\", component = \"x\" }" } else { "" }
        )
    };
    let [half, most] = [180.0, 135.0].map(|sweep| {
        let case = Case::parse(Path::new("tube.toml"), &bodies(sweep)).unwrap_or_else(|error| panic!("{error}"));
        let (_, run) = case.solve().unwrap_or_else(|error| panic!("{error}"));
        let measures = run.measures();
        [measures.peak.pressure, measures.second_moment_width, measures.half_width()]
    });
    assert_alike(half, most, 2e-3, "three quarters of it");
    assert!((half[0] / 700.86 - 1.0).abs() < 2e-3, "{half:?}");
}
