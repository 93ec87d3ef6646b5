//! Drawings made by hand: an SVG file in the colours of light pages, in which `{name}` stands for a number of the
//! scene.
//!
//! Any editor shows and changes them. On dark pages each colour is the partner it has in the palette, or below.

use svg::node::element::Style;

use super::drawing::{Drawing, Error};
use super::palette::partner;
use super::theme::exchanged;

/// The drawing of a file with its numbers, to six decimals; broken where the file asks for another number, or none of a
/// name, or has a colour of which no dark one is known.
pub fn schematic(name: &str, light: &str, numbers: &[(&str, f64)]) -> Drawing {
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
    let unknown = |colour| Error::of(name, format!("{colour} has no dark partner"), "name both in `FILLS`");
    let named = text.split('#').skip(1).map(|part| format!("#{}", part.get(..6).unwrap_or(part)));
    let colours = named.map(|colour| partner(&colour).ok_or_else(|| unknown(colour))).collect::<Result<_, _>>()?;
    let (head, shapes) = text.split_once('>').unwrap_or_default();
    Ok(format!("{head}>\n{}{shapes}", Style::new(exchanged("drawn by hand", &colours)?)))
}
