//! The planes and slices of the atlas, initial stiffness against one other number; what was measured at each point, as it is kept under
//! `snapshots/atlas`, and the chart of a plane that it makes.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::case::Case;
use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::contact::Quadrature;
use crate::error::Error;
use crate::mesh::Resolution;
use crate::named::named_enum;
use crate::solve::{Element, Formulation};
use crate::study::method::{Class, Method};
use crate::study::records;

/// Candidate stretch over the half-width at the centre: no node lies on the contact edge.
pub const STRETCH: f64 = 1.9;
/// Elements per half-width at the centre.
const ELEMENTS: usize = 8;
/// Elements per 10 mm of arc of the pin-rod.
const PIN_ROD_ELEMENTS: usize = 12;

named_enum! {
    /// Initial stiffness against one other number, all else at the centre: truncated Hertz, candidates to 1.9 half-widths, 8
    /// elements per half-width, one increment. The two full planes first, then the slices; the name is that of the record.
    pub enum Plane {
        /// Candidate stretch over the half-width.
        Stretch = "stretch",
        /// Elements per half-width.
        Mesh = "mesh",
        /// The cylinder.
        Cylinder = "cylinder",
        /// The pin-rod.
        PinRod = "pin-rod",
        /// Load increments.
        Increments = "increments",
        /// Thickness of the layer element over its edge length.
        Thickness = "thickness",
        /// Quadrature of line and layer elements.
        Quadrature = "quadrature",
    }
}

impl Plane {
    /// The scenes of the paper.
    pub const PAPER: [Self; 2] = [Self::Cylinder, Self::PinRod];

    /// What the other number is, and its values.
    fn axis(self) -> (&'static str, &'static [f64]) {
        match self {
            Self::Stretch => ("L/a", &[1.0, 1.3, 1.6, STRETCH, 2.4, 3.1, 4.0]),
            Self::Mesh => ("elements per a", &[4.0, 6.0, 8.0, 12.0, 16.0]),
            Self::Cylinder => ("elements per a", &[ELEMENTS as f64]),
            Self::PinRod => ("elements per 10 mm", &[PIN_ROD_ELEMENTS as f64]),
            Self::Increments => ("increments", &[2.0, 5.0, 10.0]),
            Self::Thickness => ("t₀ / edge length", &[1e-4, 1e-2, 1.0]),
            Self::Quadrature => ("Gauss points per edge (0: Lobatto)", &[3.0, 0.0]),
        }
    }

    /// What the other number is.
    pub fn label(self) -> &'static str {
        self.axis().0
    }

    /// The values of the other number.
    pub fn ordinates(self) -> &'static [f64] {
        self.axis().1
    }

    /// Whether it has many values of both numbers.
    pub fn is_full(self) -> bool {
        [Self::Stretch, Self::Mesh].contains(&self)
    }

    /// Whether it varies how the centre is solved: fewer initial stiffnesses, and not all of them with nodes and one increment.
    pub fn is_slice(self) -> bool {
        [Self::Increments, Self::Thickness, Self::Quadrature].contains(&self)
    }

    /// Initial stiffnesses over twelve decades: halves of them in the planes and on both paper scenes, whole ones else.
    pub fn stiffnesses(self) -> Vec<f64> {
        let halves = if self.is_slice() { 2 } else { 1 };
        (-12..=12).step_by(halves).map(|k| 10f64.powf(0.5 * f64::from(k))).collect()
    }

    /// What is run at each ordinate, in the order of the record.
    pub fn methods(self) -> Vec<Method> {
        let elements: &[Element] = match self {
            Self::Thickness => &[Element::Layer],
            Self::Quadrature => &[Element::Line, Element::Layer],
            _ => &Element::ALL,
        };
        elements.iter().flat_map(|&element| Method::of(element)).collect()
    }

    /// Its meshes, in the order of the record.
    pub fn sites(self) -> Vec<Site> {
        self.ordinates().iter().map(|&ordinate| Site { plane: self, ordinate }).collect()
    }

    /// Its lines, all but the initial stiffness fixed, in the order of the record.
    pub fn rows(self) -> Vec<(Site, Method)> {
        let methods = self.methods();
        self.sites().into_iter().flat_map(|site| methods.iter().map(move |&method| (site, method))).collect()
    }

    /// The case that the library has of it, or truncated Hertz with such candidates.
    pub fn case(self, stretch: f64) -> Case {
        match self {
            Self::Cylinder => Cylinder::default().case(),
            Self::PinRod => PinRod::default().case(),
            _ => TruncatedHertz { stretch, ..Default::default() }.case(),
        }
    }
}

/// A plane at one of its ordinates: all that is solved on one mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// The plane.
    pub plane: Plane,
    /// The other number.
    pub ordinate: f64,
}

impl Site {
    /// Name among the unfinished ones.
    pub fn key(&self) -> String {
        format!("{}-{}", self.plane.name(), self.ordinate)
    }

    /// A method as it is run here, at an initial stiffness.
    pub fn formulation(&self, method: Method, stiffness: f64) -> Formulation {
        let mut formulation = method.formulation(stiffness);
        match self.plane {
            Plane::Increments => formulation.settings.increments = self.ordinate as usize,
            Plane::Thickness => formulation.layer_thickness = self.ordinate,
            Plane::Quadrature => {
                formulation.quadrature = if self.ordinate > 0.0 { Quadrature::GaussFull } else { Quadrature::Lobatto };
            }
            _ => {}
        }
        formulation
    }

    /// The case on its mesh.
    pub fn case(&self) -> Case {
        let (stretch, elements) = match self.plane {
            Plane::Stretch => (self.ordinate, ELEMENTS),
            Plane::Mesh | Plane::Cylinder | Plane::PinRod => (STRETCH, self.ordinate as usize),
            Plane::Increments | Plane::Thickness | Plane::Quadrature => (STRETCH, ELEMENTS),
        };
        let case = self.plane.case(stretch);
        Case { resolution: Resolution { elements, ..case.resolution }, ..case }
    }
}

/// Error of p₀ and a that a run within the default tolerance may have.
pub const RIGHT: f64 = 3e-3;

/// What renews the records.
pub const RENEW: &str = "run `cargo run --release -- atlas` and review the diff of snapshots/atlas";

/// One point.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    /// What was run.
    pub method: Method,
    /// The plane's other number.
    pub ordinate: f64,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// How it ended.
    pub class: Class,
    /// Iterations made; zero where an error keeps them.
    pub iterations: usize,
    /// Larger error of p₀ and a against the solution of the same discrete problem; NaN where an error keeps them.
    pub error: f64,
    /// Larger error of p₀ and a that the springs of a penalty make; none without one.
    pub penalty: Option<f64>,
    /// Iterations predicted, infinite where it shall not converge; none where none are.
    pub predicted_iterations: Option<f64>,
}

impl Record {
    /// Error of p₀ and a with that of a penalty, which may stop far from the solution.
    pub fn off(&self) -> f64 {
        self.error + self.penalty.unwrap_or_default()
    }

    /// Whether the run stopped where it shall.
    pub fn is_right(&self) -> bool {
        self.class == Class::Converged && self.off() <= RIGHT
    }
}

/// Equal but for the digits a text file leaves out.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * a.abs().max(b.abs())
}

/// Columns of a record, its fields.
pub const HEAD: [&str; 8] =
    ["formulation", "ordinate", "stiffness", "class", "iterations", "error", "penalty", "predicted_iterations"];

/// The records of a plane, a line per row of the plan.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The plane.
    pub plane: Plane,
    /// Records by row, then by initial stiffness.
    pub rows: Vec<Vec<Record>>,
}

impl Chart {
    /// The records in the order of the plan.
    pub fn of(plane: Plane, records: &[Record]) -> Self {
        Self { plane, rows: records.chunks(plane.stiffnesses().len()).map(<[Record]>::to_vec).collect() }
    }

    /// The record of a plane; refused where it does not hold exactly the points of the plan.
    pub fn read(plane: Plane) -> Result<Self, Error> {
        Self::read_from(&file(plane), plane)
    }

    /// The same from another file.
    pub fn read_from(path: &Path, plane: Plane) -> Result<Self, Error> {
        let records: Vec<Record> = records::read(path, &records::named(HEAD), RENEW)?;
        let of_row = |(site, method): (Site, Method)| plane.stiffnesses().into_iter().map(move |k| (site, method, k));
        let planned: Vec<(Site, Method, f64)> = plane.rows().into_iter().flat_map(of_row).collect();
        let is_at = |(record, (site, method, k)): (&Record, &(Site, Method, f64))| {
            record.method == *method && same(record.ordinate, site.ordinate) && same(record.stiffness, *k)
        };
        if records.len() != planned.len() || !records.iter().zip(&planned).all(is_at) {
            let found = format!("{} points that are not the {} of the plan", records.len(), planned.len());
            return Err(Error::refused(path, "points", found, RENEW));
        }
        Ok(Self::of(plane, &records))
    }

    /// Rows of a method, by growing ordinate.
    pub fn of_method(&self, method: Method) -> impl Iterator<Item = &[Record]> {
        self.rows.iter().map(Vec::as_slice).filter(move |row| row[0].method == method)
    }

    /// Whether a neighbour in stiffness or in the other number ended in another class.
    pub fn is_near_a_boundary(&self, row: usize, column: usize) -> bool {
        let across = self.plane.methods().len();
        let beside = [column.checked_sub(1), Some(column + 1)].map(|column| Some((row, column?)));
        let above = [row.checked_sub(across), Some(row + across)].map(|row| Some((row?, column)));
        let places = beside.into_iter().chain(above).flatten();
        let mut neighbours = places.filter_map(|(row, column)| self.rows.get(row)?.get(column));
        neighbours.any(|other| other.class != self.rows[row][column].class)
    }

    /// What is frozen: the iterations where all neighbours ended alike, the class alone near a boundary.
    pub fn frozen(&self) -> String {
        let mut text = format!("{}; κ₀ from 1e-6 to 1e6\n", self.plane.label());
        for (r, row) in self.rows.iter().enumerate() {
            let _ = write!(text, "{} {}:", row[0].method, row[0].ordinate);
            for (c, record) in row.iter().enumerate() {
                let _ = match record.class {
                    Class::Converged if !self.is_near_a_boundary(r, c) => write!(text, " {}", record.iterations),
                    class => write!(text, " {}", class.name()),
                };
            }
            text.push('\n');
        }
        text
    }
}

/// The record of a plane.
pub fn file(plane: Plane) -> PathBuf {
    records::file(&format!("atlas/{}", plane.name()))
}
