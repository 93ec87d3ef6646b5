//! How a file is to be read: which column is what, in which unit, of which contact.

use crate::error::Error;
use crate::mesh::Order;
use crate::referee::units::{Role, Units};

/// How files are to be read, where they do not say so themselves.
#[derive(Clone, Debug, Default)]
pub struct Asked {
    /// Columns, or fields, by what they hold.
    pub columns: Vec<(Role, String)>,
    /// Units by what they are of.
    pub units: Vec<(Role, String)>,
    /// How the points follow one another; edges with two nodes unless the file says otherwise.
    pub order: Option<Order>,
    /// Name of the contact.
    pub contact: Option<String>,
    /// Whether pressures and forces are positive in tension.
    pub tension_positive: bool,
    /// Time of the state that is judged, of files with several; the last one where neither it nor the step is named.
    pub time: Option<f64>,
    /// Step at whose end the state is.
    pub step: Option<usize>,
}

impl Asked {
    /// The column that was named for a role.
    pub fn column(&self, role: Role) -> Option<&str> {
        self.columns.iter().find(|(known, _)| *known == role).map(|(_, name)| name.as_str())
    }

    /// The unit that was named for a role.
    pub fn unit(&self, role: Role) -> Option<&str> {
        self.units.iter().find(|(known, _)| *known == role).map(|(_, unit)| unit.as_str())
    }

    /// All that were named.
    pub fn units(&self) -> Units {
        let [position, pressure, force, gap, area] =
            [Role::Position, Role::Pressure, Role::Force, Role::Gap, Role::Area]
                .map(|role| self.unit(role).map(str::to_owned));
        Units { position, pressure, force, gap, area }
    }

    /// Whether one of several states is asked for.
    pub fn has_state(&self) -> bool {
        self.time.is_some() || self.step.is_some()
    }

    /// 1, or −1 where compression is negative.
    pub fn sign(&self) -> f64 {
        if self.tension_positive { -1.0 } else { 1.0 }
    }

    /// The unit that `ROLE=UNIT` names, one that is known of the role.
    pub fn unit_of(text: &str) -> Result<(Role, String), Error> {
        let (role, unit) = Self::pair("--unit", text)?;
        if role.factor(&unit).is_none() {
            let message = format!("`--unit {text}` names no unit of {}", role.name());
            let remedy = match role.known_units() {
                known if known.is_empty() => "leave it out: it has none".into(),
                known => format!("name one of {known}"),
            };
            return Err(Error::at("judge", message, remedy));
        }
        Ok((role, unit))
    }

    /// What `ROLE=TEXT` says.
    pub fn pair(option: &str, text: &str) -> Result<(Role, String), Error> {
        let roles = Role::NAMES.join(", ");
        let refused =
            |message: String| Error::at("judge", message, format!("write {option} ROLE=NAME, ROLE one of {roles}"));
        let Some((role, name)) = text.split_once('=') else {
            return Err(refused(format!("`{option} {text}` has no `=`")));
        };
        let known = Role::named(role).ok_or_else(|| refused(format!("`{option} {text}` names no role")))?;
        Ok((known, name.to_owned()))
    }
}
