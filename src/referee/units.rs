//! Units of another code's numbers, and what each is in ours: mm, rad, MPa, N, mm².

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::named::named_enum;

named_enum! {
    /// What a list of numbers holds; its name is also that of a column.
    pub enum Role {
        /// Contact coordinate: a length on a straight path, an angle from the load line on an arc.
        Position = "position",
        /// Cartesian coordinate along x.
        X = "x",
        /// Cartesian coordinate along y.
        Y = "y",
        /// Contact pressure, positive in compression.
        Pressure = "pressure",
        /// Nodal contact force along the normal, positive in compression.
        Force = "force",
        /// Remaining gap, positive where open.
        Gap = "gap",
        /// Tributary area.
        Area = "area",
        /// Name of the contact.
        Contact = "contact",
        /// Displacement of a node, a vector.
        Displacement = "displacement",
        /// Stress at a node, positive in tension: 9 components row by row, or 6 in VTK's order xx, yy, zz, xy, yz, xz.
        Stress = "stress",
    }
}

impl Role {
    /// Those of a table.
    pub const OF_TABLES: [Self; 8] =
        [Self::Position, Self::X, Self::Y, Self::Pressure, Self::Force, Self::Gap, Self::Area, Self::Contact];

    /// Names that columns and fields have without being named, in small letters, the one that goes first in front:
    /// those of contacts, then those that may be of a body. They are our own, and those of ParaView, MOOSE, Abaqus,
    /// Ansys, COMSOL, code_aster and CalculiX.
    pub fn usual(self) -> &'static [&'static str] {
        match self {
            Self::Position => &[
                "position",
                "arc_length",
                "arc length",
                "length",
                "distance",
                "true distance along path",
                "theta",
                "angle",
            ],
            Self::X => &[
                "x",
                "points:0",
                "points_0",
                "coord.coor1",
                "coor1",
                "x location",
                "x coordinate",
                "coor_x",
                "coord_x",
                "locx",
                "xg",
                "r",
            ],
            Self::Y => &[
                "y",
                "points:1",
                "points_1",
                "coord.coor2",
                "coor2",
                "y location",
                "y coordinate",
                "coor_y",
                "coord_y",
                "locy",
                "yg",
                "z",
            ],
            Self::Pressure => &[
                "contact_pressure",
                "contact pressure",
                "contact_normal_lm",
                "contpres",
                "normal pressure",
                "cpress",
                "solid.tn",
                "pressure",
                "pres",
                "lags_c",
                "tn",
                "p",
            ],
            Self::Force => &["force", "contact_force", "contact force"],
            Self::Gap => &["contact_gap", "contact gap", "gap", "copen", "solid.gap"],
            Self::Area => &["area", "nodal_area", "cnarea"],
            Self::Contact => &["contact"],
            Self::Displacement => &["displacement", "displacements", "disp", "u"],
            Self::Stress => &["stress"],
        }
    }

    /// Units that it may have, each with its value in ours.
    pub fn units(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Position => &PLACES,
            Self::X | Self::Y | Self::Gap | Self::Displacement => &LENGTHS,
            Self::Pressure | Self::Stress => &PRESSURES,
            Self::Force => &FORCES,
            Self::Area => &AREAS,
            Self::Contact => &[],
        }
    }

    /// What a unit of it is in ours; none where that is not known. `N/mm²`, `N / mm^2` and `N·mm⁻²` are `N/mm2`, `µm`
    /// is `um`, `inch` is `in`; `MPA` and `Mpa` are `MPa`, but `mPa` is none of these.
    pub fn factor(self, unit: &str) -> Option<f64> {
        let plain = unit
            .replace(['^', '*', '·', ' '], "")
            .replace('⁻', "-")
            .replace('²', "2")
            .replace(['µ', 'μ'], "u")
            .replace("inch", "in");
        let usual = LETTERS.iter().find(|(own, _)| *own == plain).map_or(&*plain, |(_, usual)| usual);
        self.units().iter().find(|(known, _)| *known == usual).map(|(_, factor)| *factor)
    }

    /// What is wrong, and what to do, where a file says one unit and --unit names another; none where both are one, or
    /// one is not known.
    pub fn contradiction(self, what: &str, (written, named): (&str, &str)) -> Option<[String; 2]> {
        let ([own, other], option) =
            ([self.factor(written)?, self.factor(named)?], format!("--unit {}={named}", self.name()));
        let is_one = (own / other - 1.0).abs() <= SAME && is_angle(written) == is_angle(named);
        let remedy =
            format!("leave out {option} where the file is right, for which it is not needed; else correct the file");
        (!is_one).then(|| [format!("{what} is in {written} by the file, but in {named} by {option}"), remedy])
    }

    /// Names of its units, in a row.
    pub fn known_units(self) -> String {
        self.units().iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
    }
}

/// Part of a factor by which two units are one.
const SAME: f64 = 1e-12;
const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// Pound-force \[N\] and inch \[mm\], both by definition.
const POUND: f64 = 4.448_221_615_260_5;
const INCH: f64 = 25.4;
const PSI: f64 = POUND / (INCH * INCH);
/// Units in the capital letters in which programs write them, where no other has these.
const LETTERS: [(&str, &str); 9] = [
    ("MPA", "MPa"),
    ("Mpa", "MPa"),
    ("GPA", "GPa"),
    ("KPA", "kPa"),
    ("N/MM2", "N/mm2"),
    ("Nmm-2", "N/mm2"),
    ("Nm-2", "N/m2"),
    ("PSI", "psi"),
    ("MM", "mm"),
];
const PLACES: [(&str, f64); 10] = [
    ("mm", 1.0),
    ("m", 1e3),
    ("um", 1e-3),
    ("nm", 1e-6),
    ("cm", 10.0),
    ("in", INCH),
    ("ft", 12.0 * INCH),
    ("rad", 1.0),
    ("deg", DEGREE),
    ("°", DEGREE),
];
const LENGTHS: [(&str, f64); 7] =
    [("mm", 1.0), ("m", 1e3), ("um", 1e-3), ("nm", 1e-6), ("cm", 10.0), ("in", INCH), ("ft", 12.0 * INCH)];
const PRESSURES: [(&str, f64); 15] = [
    ("MPa", 1.0),
    ("N/mm2", 1.0),
    ("kPa", 1e-3),
    ("Pa", 1e-6),
    ("GPa", 1e3),
    ("kN/mm2", 1e3),
    ("N/m2", 1e-6),
    ("MN/m2", 1.0),
    ("bar", 0.1),
    ("atm", 0.101_325),
    ("psi", PSI),
    ("ksi", 1e3 * PSI),
    ("lbf/in2", PSI),
    ("kgf/mm2", 9.806_65),
    ("kgf/cm2", 0.098_066_5),
];
const FORCES: [(&str, f64); 3] = [("N", 1.0), ("kN", 1e3), ("lbf", POUND)];
const AREAS: [(&str, f64); 4] = [("mm2", 1.0), ("m2", 1e6), ("cm2", 100.0), ("in2", INCH * INCH)];

/// Whether a unit is one of angles.
pub fn is_angle(unit: &str) -> bool {
    ["rad", "deg", "°"].contains(&unit)
}

/// Units of an answer as JSON; those of lists that are not there may be left out.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// Of positions: mm, m, um, nm, cm, in or ft on a straight path; deg or rad on an arc.
    pub position: Option<String>,
    /// Of pressures: MPa, N/mm2, kPa, Pa, GPa, kN/mm2, N/m2, MN/m2, bar, atm, psi, ksi, lbf/in2, kgf/mm2 or kgf/cm2.
    pub pressure: Option<String>,
    /// Of forces: N, kN or lbf.
    pub force: Option<String>,
    /// Of gaps: mm, m, um, nm, cm, in or ft.
    pub gap: Option<String>,
    /// Of areas: mm2, m2, cm2 or in2.
    pub area: Option<String>,
}

impl Units {
    /// The unit of a role; none where it is not given.
    pub fn of(&self, role: Role) -> Option<&str> {
        match role {
            Role::Position => self.position.as_deref(),
            Role::Pressure => self.pressure.as_deref(),
            Role::Force => self.force.as_deref(),
            Role::Gap => self.gap.as_deref(),
            Role::Area => self.area.as_deref(),
            Role::X | Role::Y | Role::Contact | Role::Displacement | Role::Stress => None,
        }
    }
}
