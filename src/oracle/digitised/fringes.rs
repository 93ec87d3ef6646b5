//! Dark fringes of a photoelastic disc, read from a photograph.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::keys::text_of;
use crate::checkout::root;
use crate::error::Error;
use crate::named::named_enum;

named_enum! {
    /// One of the loaded ends of the vertical diameter.
    pub enum End {
        /// The lower one.
        Bottom = "bottom",
        /// The upper one.
        Top = "top",
    }
}

named_enum! {
    /// Colour channel of the photograph.
    pub enum Channel {
        /// Red.
        R = "R",
        /// Green.
        G = "G",
        /// Blue.
        B = "B",
    }
}

/// A pair of dark points on a horizontal line, left and right of the loaded diameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fringe {
    /// The end near which the line lies.
    pub end: End,
    /// Distance of the line from that end, over the radius.
    #[serde(rename = "z_over_R")]
    pub depth: f64,
    /// Channel.
    pub channel: Channel,
    /// Fringe order.
    #[serde(rename = "order_N")]
    pub order: f64,
    /// Half the distance between the two points, over the radius.
    #[serde(rename = "half_spacing_over_R")]
    pub half_spacing: f64,
    /// Half the difference of their distances from the diameter, over the radius.
    #[serde(rename = "left_right_half_difference_over_R")]
    pub scatter: f64,
}

/// What restores the file.
const RESTORE: &str = "restore it from version control";

/// The fringes at hand.
pub fn file() -> PathBuf {
    root().join("oracles/digitised/photoelastic-disc/fringes.csv")
}

/// Every fringe of a file.
///
/// # Errors
/// Names the file, and the line with what is wrong in it.
pub fn read(file: &Path) -> Result<Vec<Fringe>, Error> {
    let text = text_of(file, RESTORE)?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let fringes: Vec<Fringe> =
        reader.deserialize().collect::<Result<_, _>>().map_err(|error| Error::unreadable(file, error, RESTORE))?;
    let bad = fringes.iter().position(|fringe| {
        let Fringe { depth, order, half_spacing, scatter, .. } = *fringe;
        let good = depth > 0.0
            && depth < 1.0
            && order >= 1.0
            && half_spacing > 0.0
            && half_spacing < 1.0
            && scatter.is_finite();
        !good
    });
    match bad {
        None if !fringes.is_empty() => Ok(fringes),
        None => Err(Error::file(file, "no fringe in it", RESTORE)),
        Some(row) => {
            let message = format!("line {}: depth and spacing lie between 0 and 1, orders are 1 or more", row + 2);
            Err(Error::file(file, message, RESTORE))
        }
    }
}
