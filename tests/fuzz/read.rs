//! What the fuzz targets do with their bytes, and the claims with the corpus: read and mesh, solve nothing.
//!
//! Each function returns what a user would be told. A panic, a hang or a mesh much larger than announced is a bug.
#![allow(dead_code, reason = "each target calls one of the functions")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use contact_vv::case::Case;
use contact_vv::case::library::find;
use contact_vv::error::Error;
use contact_vv::mesh::Mesh;
use contact_vv::mesh::size::expected;
use contact_vv::oracle::cross_code::Code;
use contact_vv::oracle::cross_code::frozen::{Frozen, file};
use contact_vv::oracle::digitised::{OurPoint, compare, load};
use contact_vv::referee::export::deck;
use contact_vv::referee::judge::ENGINEERING;
use contact_vv::referee::read::parse;
use contact_vv::referee::units::Role;
use contact_vv::referee::{Answer, Asked, Truth, calculix, verdicts};
use contact_vv::solve::Discretisation;
use contact_vv::study::differences::changes;

/// Most cells of a scene that is meshed.
const FEW: f64 = 1000.0;

/// A scene file, which may name meshes that do not exist.
pub fn scene(bytes: &[u8]) -> Result<(), Error> {
    mesh_of(&Case::parse(&folder().join("absent/scene.toml"), &String::from_utf8_lossy(bytes))?)
}

/// A mesh of Gmsh, or a deck where it begins with a star, of whose groups a scene makes two bodies.
pub fn mesh(bytes: &[u8]) -> Result<(), Error> {
    write(&folder().join("mesh.msh"), bytes);
    mesh_of(&Case::parse(&folder().join("scene.toml"), include_str!("mesh.toml"))?)
}

/// Meshes a scene with few cells.
fn mesh_of(case: &Case) -> Result<(), Error> {
    let [announced, _] = expected(&case.scene, case.resolution);
    if announced <= FEW {
        let cells = Mesh::of(&case.scene, case.resolution)?.cells() as f64;
        assert!(cells <= 8.0 * announced + 64.0, "{cells} cells instead of {announced}");
    }
    Ok(())
}

/// Frozen answers of another code, compared with those committed.
pub fn answers(bytes: &[u8]) -> Result<(), Error> {
    static COMMITTED: LazyLock<Frozen> = LazyLock::new(|| Frozen::load(Code::ScikitFem).expect("frozen results"));
    let read = Frozen::parse(&file(Code::ScikitFem), &String::from_utf8_lossy(bytes))?;
    assert!(!changes(Code::ScikitFem, &COMMITTED, &read).is_empty());
    let current = read.scripts == COMMITTED.scripts;
    assert_eq!(read.of_scripts(Code::ScikitFem, &COMMITTED.scripts).is_ok(), current);
    Ok(())
}

/// The answer of another code to the case `bars`: the ending of its file on the first line, and the file behind it;
/// judged where it is read.
pub fn handed(bytes: &[u8]) -> Result<(), Error> {
    static BARS: LazyLock<(Truth, Discretisation, String)> = LazyLock::new(|| {
        let case = find("bars", None).expect("a case");
        let own = case.meshed().expect("meshed").discretisation;
        let deck = deck::text(&own).expect("written");
        (Truth::of(case).expect("a truth"), own, deck)
    });
    let (truth, own, deck) = &*BARS;
    let begin = bytes.iter().position(|byte| *byte == b'\n').unwrap_or(bytes.len());
    let (ending, content) = (String::from_utf8_lossy(&bytes[..begin]), bytes.get(begin + 1..).unwrap_or_default());
    let units = [
        (Role::Position, "mm"),
        (Role::Pressure, "MPa"),
        (Role::Gap, "mm"),
        (Role::Displacement, "mm"),
        (Role::Stress, "MPa"),
    ];
    let units = units.map(|(role, unit)| (role, unit.to_owned()));
    let fields = ["vtu", "vtk", "frd"].contains(&&*ending);
    let asked = Asked { units: if fields { units.into() } else { vec![] }, ..Asked::default() };
    let file = Path::new("answer").with_extension(ending.replace(['/', '\\', '\0'], ""));
    let answer = match &*ending {
        "dat" => calculix::forces(&file, &String::from_utf8_lossy(content), deck, &truth.case.scene, &asked)?,
        _ => parse(&file, content, &truth.case, &asked)?,
    };
    if let Some(field) = &answer.field {
        let _ = field.at_nodes(own);
    }
    let judged = verdicts(truth, Answer { field: None, ..answer }, ENGINEERING)?;
    assert!(judged.ruled.iter().all(|ruled| !ruled.judged.is_empty()));
    Ok(())
}

/// A digitised curve; behind lines of `%%` the scene and the provenance of its figure.
pub fn curve(bytes: &[u8]) -> Result<(), Error> {
    let folder = folder().join("curve");
    let defaults = [
        include_str!("../data/digitised-synthetic/semi-ellipse.csv"),
        include_str!("../data/digitised-synthetic/scene.toml"),
        include_str!("../data/digitised-synthetic/provenance.toml"),
    ];
    let text = String::from_utf8_lossy(bytes).into_owned();
    let mut given = text.split("\n%%\n");
    for (name, default) in ["semi-ellipse.csv", "scene.toml", "provenance.toml"].into_iter().zip(defaults) {
        write(&folder.join(name), given.next().unwrap_or(default).as_bytes());
    }
    if let Ok(curves) = load(&folder)? {
        curves.iter().for_each(|curve| drop(compare(curve, &|at| OurPoint { value: at, uncertainty: at })));
    }
    Ok(())
}

/// A folder of this process.
fn folder() -> &'static Path {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        let folder = std::env::temp_dir().join(format!("contact-vv-fuzz-{}", std::process::id()));
        fs::create_dir_all(folder.join("curve")).expect("a folder");
        folder
    });
    &FOLDER
}

fn write(file: &Path, bytes: &[u8]) {
    fs::write(file, bytes).expect("written");
}

/// Removes what this process has written.
pub fn clear() {
    fs::remove_dir_all(folder()).expect("removed");
}

/// Prints what a user would be told, where `run.py` asks for it.
pub fn tell(read: Result<(), Error>) {
    static ASKED: LazyLock<bool> = LazyLock::new(|| std::env::var_os("CONTACT_VV_TELL").is_some());
    let told = match read {
        Ok(()) => "read".into(),
        Err(error) => {
            assert!(!error.message.trim().is_empty() && !error.remedy.trim().is_empty(), "{error:?}");
            format!("{} {}", error.message, error.remedy)
        }
    };
    if *ASKED {
        println!("told: {}", told.replace('\n', " "));
    }
}
