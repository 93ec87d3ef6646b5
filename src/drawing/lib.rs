//! Figures as byte-stable SVG text, for light and for dark pages; a figure that cannot be drawn says so when it is
//! written.
//!
//! Conventions, the same in every figure: the colour names the contact element, the dash the algorithm, the marker the
//! mesh or the formulation; references are black and dashed, measured values are points without a line, and runs that
//! did not converge are drawn as hollow markers above the chart.
//!
//! * [`chart`]: curves over linear or logarithmic axes.
//! * [`class_map`]: how runs ended, over two numbers.
//! * [`multiples`]: charts side by side over one legend, or below a field.
//! * [`field`]: a scalar on the deformed mesh, in bands.
//! * [`fn@schematic`]: drawings made by hand, with numbers of a scene.
//! * [`palette`]: colours, dashes, markers and the styles made of them; colours of fields and of classes.
//! * [`theme`]: light and dark pages; [`Drawing`]: a finished figure, for both.
//!
//! Below these: `canvas` writes shapes as SVG, with the help of `outline`, `pen` sets lines and text, `frame` clips to
//! a rectangle; `axis` places and writes ticks, `plot`, `annotations`, `curves`, `signs`, `legend` and `drawn` draw a
//! chart; `field_panels`, `bands`, `mesh_lines` and `marks` a field.

mod annotations;
mod axis;
mod bands;
mod canvas;
pub mod chart;
pub mod class_map;
mod curves;
mod drawing;
mod drawn;
pub mod field;
mod field_panels;
mod frame;
mod legend;
mod marks;
mod mesh_lines;
pub mod multiples;
mod outline;
pub mod palette;
mod pen;
mod plot;
mod schematic;
mod signs;
pub mod theme;

pub use chart::{Axis, Bars, Chart, Direction, Guide, Remark, Scale, Series, Slope};
pub use class_map::{Cell, ClassMap, MapPanel};
pub use drawing::{Drawing, Error, is_drawing};
pub use field::{Detail, Field, Mark, Window};
pub use multiples::{Sheet, panels};
pub use palette::{ColourMap, Dash, Marker, Style};
pub use schematic::schematic;
pub use theme::{Colour, Theme};
