//! The colour bar beside a field.

use super::bands::Bands;
use super::canvas::Canvas;
use super::frame::Frame;
use super::numbers::number;
use super::palette::GREY;
use super::pen::{Lettering, Pen};

/// The bands one above the other with their ends, and the quantity over them.
pub(super) fn colour_bar(canvas: &mut Canvas, bands: &Bands, frame: Frame, quantity: &str) {
    let height = frame.height().min(26.0 * bands.count() as f64);
    let level = |n: usize| frame.top + height * (1.0 - n as f64 / bands.count() as f64);
    for band in 0..bands.count() {
        let step = Frame { top: level(band + 1), bottom: level(band) + 0.3, ..frame };
        canvas.area(&step.corners(), bands.colour(band));
    }
    let whole = Frame { bottom: frame.top + height, ..frame };
    canvas.line(&whole.outline(), Pen::solid(GREY, 0.8));
    for (n, &value) in bands.levels.iter().enumerate() {
        canvas.line(&[(frame.right, level(n)), (frame.right + 3.5, level(n))], Pen::solid(GREY, 0.8));
        canvas.label(
            (frame.right + 7.0, level(n)),
            &number(value, bands.step, bands.largest()),
            Lettering::start(10.5),
        );
    }
    canvas.label((frame.left, frame.top - 15.0), quantity, Lettering::start(11.5));
}
