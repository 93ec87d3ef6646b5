//! Drawings made by hand: an SVG file in the colours of light pages, in which `{name}` stands for a number of the scene.
//!
//! Any editor shows and changes them. On dark pages each colour is the partner it has in the palette, or below.

use super::drawing::Drawing;
use super::error::Error;
use super::palette::{CARD, CURVES, GREY, INK, PALE};
use super::theme::{Colour, Theme};

/// Bodies: of the element, of the layer, of the pin, of the rod; and the springs of a line element.
const FILLS: [Colour; 8] = [
    Colour::new(0xE5E5E4, 0x2C2F34),
    Colour::new(0xF0D7C5, 0x452E21),
    Colour::new(0xCCE2EF, 0x364855),
    Colour::new(0xD2E5F0, 0x32424E),
    Colour::new(0xB9D7E9, 0x445B6B),
    Colour::new(0xEFE5CF, 0x3D3422),
    Colour::new(0x338EC1, 0x4C8CBE),
    PALE,
];

/// The drawing of a file with its numbers, to six decimals; broken where the file asks for another number, or none of a name, or
/// has a colour of which no dark one is known.
pub fn schematic(name: &str, light: &str, numbers: &[(&str, f64)]) -> Drawing {
    Drawing::of(filled_in(name, light, numbers))
}

fn filled_in(name: &str, light: &str, numbers: &[(&str, f64)]) -> Result<Drawing, Error> {
    let mut text = light.to_owned();
    for (number, value) in numbers {
        let place = format!("{{{number}}}");
        if !value.is_finite() || !text.contains(&place) {
            return Err(Error::of(
                name,
                format!("`{number}` = {value} has no place"),
                "give finite numbers that it asks for",
            ));
        }
        let rounded = (value * 1e6).round() / 1e6;
        text = text.replace(&place, &rounded.to_string().replace('-', "−"));
    }
    if let Some((_, asked)) = text.split_once('{') {
        let asked = asked.split('}').next().unwrap_or_default();
        return Err(Error::of(name, format!("`{asked}` has no number"), "give it"));
    }
    let unknown = colours_of(&text).find(|colour| partner(colour).is_none());
    match unknown {
        Some(unknown) => Err(Error::of(name, format!("{unknown} has no dark partner"), "name both in `FILLS`")),
        None => Ok(Drawing::Schematic(text)),
    }
}

/// The text in the colours of a page.
pub(super) fn on(light: &str, theme: Theme) -> String {
    let mut parts = light.split('#');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| {
        let (colour, rest) = part.split_at_checked(6).unwrap_or((part, ""));
        let themed = partner(&format!("#{colour}")).map(|pair| pair.on(theme).to_string());
        text + &themed.unwrap_or_else(|| format!("#{colour}")) + rest
    })
}

fn colours_of(text: &str) -> impl Iterator<Item = String> {
    text.split('#').skip(1).map(|part| format!("#{}", part.get(..6).unwrap_or(part)))
}

/// The colour of a page for light ones.
fn partner(light: &str) -> Option<Colour> {
    CURVES.into_iter().chain([INK, GREY, CARD]).chain(FILLS).find(|one| one.on(Theme::Light).to_string() == light)
}
