//! Units of another code's numbers, and what each is in ours: mm, rad, MPa, N, mm².

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a list of numbers holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// Contact coordinate: a length on a straight path, an angle from the load line on an arc.
    Position,
    /// Cartesian coordinate along x.
    X,
    /// Cartesian coordinate along y.
    Y,
    /// Contact pressure, positive in compression.
    Pressure,
    /// Nodal contact force along the normal, positive in compression.
    Force,
    /// Remaining gap, positive where open.
    Gap,
    /// Tributary area.
    Area,
    /// Name of the contact.
    Contact,
    /// Displacement of a node, a vector.
    Displacement,
    /// Stress at a node, positive in tension: 9 components row by row, or 6 in VTK's order xx, yy, zz, xy, yz, xz.
    Stress,
}

impl Role {
    /// All.
    pub const ALL: [Self; 10] = [
        Self::Position,
        Self::X,
        Self::Y,
        Self::Pressure,
        Self::Force,
        Self::Gap,
        Self::Area,
        Self::Contact,
        Self::Displacement,
        Self::Stress,
    ];

    /// Those of a table.
    pub const OF_TABLES: [Self; 8] =
        [Self::Position, Self::X, Self::Y, Self::Pressure, Self::Force, Self::Gap, Self::Area, Self::Contact];

    /// Its name, which is also that of a column.
    pub fn name(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::X => "x",
            Self::Y => "y",
            Self::Pressure => "pressure",
            Self::Force => "force",
            Self::Gap => "gap",
            Self::Area => "area",
            Self::Contact => "contact",
            Self::Displacement => "displacement",
            Self::Stress => "stress",
        }
    }

    /// The role of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.name() == name)
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

    /// What a unit of it is in ours; none where that is not known.
    pub fn factor(self, unit: &str) -> Option<f64> {
        self.units().iter().find(|(known, _)| *known == unit).map(|(_, factor)| *factor)
    }

    /// Names of its units, in a row.
    pub fn known_units(self) -> String {
        self.units().iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
    }
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;
const PLACES: [(&str, f64); 6] = [("mm", 1.0), ("m", 1e3), ("um", 1e-3), ("rad", 1.0), ("deg", DEGREE), ("°", DEGREE)];
const LENGTHS: [(&str, f64); 3] = [("mm", 1.0), ("m", 1e3), ("um", 1e-3)];
const PRESSURES: [(&str, f64); 5] = [("MPa", 1.0), ("N/mm2", 1.0), ("kPa", 1e-3), ("Pa", 1e-6), ("GPa", 1e3)];
const FORCES: [(&str, f64); 2] = [("N", 1.0), ("kN", 1e3)];
const AREAS: [(&str, f64); 2] = [("mm2", 1.0), ("m2", 1e6)];

/// Whether a unit is one of angles.
pub fn is_angle(unit: &str) -> bool {
    ["rad", "deg", "°"].contains(&unit)
}

/// Units of an answer as JSON; those of lists that are not there may be left out.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// Of positions: mm, m or um on a straight path; deg or rad on an arc.
    pub position: Option<String>,
    /// Of pressures: MPa, N/mm2, kPa, Pa or GPa.
    pub pressure: Option<String>,
    /// Of forces: N or kN.
    pub force: Option<String>,
    /// Of gaps: mm, m or um.
    pub gap: Option<String>,
    /// Of areas: mm2 or m2.
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
