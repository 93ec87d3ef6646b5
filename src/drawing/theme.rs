//! Light and dark pages: every colour is a pair, one for each, and its contrast can be computed.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::drawing::Error;

/// Which page a figure is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theme {
    /// A light page.
    Light,
    /// A dark page.
    Dark,
}

impl Theme {
    /// Both.
    pub const ALL: [Theme; 2] = [Theme::Light, Theme::Dark];
}

/// Red, green and blue of the standard screen (sRGB).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rgb(pub u8, pub u8, pub u8);

impl fmt::Display for Rgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02X}{:02X}{:02X}", self.0, self.1, self.2)
    }
}

/// A colour of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Colour {
    light: Rgb,
    dark: Rgb,
}

impl Colour {
    /// What is drawn on a light page, and what on a dark one, as `0xRRGGBB`.
    pub const fn new(light: u32, dark: u32) -> Colour {
        Colour { light: rgb(light), dark: rgb(dark) }
    }

    /// One that is the same on both.
    pub const fn same(both: u32) -> Colour {
        Colour::new(both, both)
    }

    /// What is drawn on a page.
    pub fn on(self, theme: Theme) -> Rgb {
        match theme {
            Theme::Light => self.light,
            Theme::Dark => self.dark,
        }
    }
}

const fn rgb(hex: u32) -> Rgb {
    let [_, red, green, blue] = hex.to_be_bytes();
    Rgb(red, green, blue)
}

/// A mixture: share 0 is the first, 1 the second.
pub(super) fn blend(from: Colour, to: Colour, share: f64) -> Colour {
    let channel = |a: u8, b: u8| (f64::from(a) + share * (f64::from(b) - f64::from(a))).round() as u8;
    let mix = |a: Rgb, b: Rgb| Rgb(channel(a.0, b.0), channel(a.1, b.1), channel(a.2, b.2));
    Colour { light: mix(from.light, to.light), dark: mix(from.dark, to.dark) }
}

/// The style sheet that exchanges the colours of light pages for those of dark ones, where a reader prefers these.
///
/// Refused where one colour of a light page would be two on a dark one.
pub(super) fn exchanged(figure: &str, colours: &BTreeSet<Colour>) -> Result<String, Error> {
    let mut partners = BTreeMap::new();
    for &Colour { light, dark } in colours {
        if let Some(other) = partners.insert(light, dark).filter(|other| *other != dark) {
            let what = format!("{light} is both {other} and {dark} on dark pages");
            return Err(Error::of(figure, what, "let one of them be another colour on light pages"));
        }
    }
    let rule = |(light, dark): (Rgb, Rgb)| {
        ["fill", "stroke"].map(|what| format!("[{what}=\"{light}\"]{{{what}:{dark}}}\n")).concat()
    };
    let rules: String = partners.into_iter().filter(|(light, dark)| light != dark).map(rule).collect();
    Ok(format!("@media(prefers-color-scheme:dark){{\n{rules}}}"))
}
