//! Options of `judge`.

use std::path::PathBuf;

use clap::Args;

use crate::accuracy;
use crate::case::Case;
use crate::cli::choice::choice;
use crate::cli::judge::told;
use crate::cli::writable::{self, Output};
use crate::drawing;
use crate::error::Error;
use crate::mesh::Order;
use crate::referee::Asked;
use crate::referee::judge::ENGINEERING;
use crate::referee::units::Role;

/// Arguments of `judge`.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Case of the library (`list` names them), or a scene file.
    pub case: String,
    /// Answers: .csv, .tsv, .txt, .rpt or .lis (columns `position [mm]`, `pressure [MPa]` or `force [N]`), .json
    /// (`schema answer`), .vtu, .vtk or .pvd (nodal pressure or stress), .frd (contact fields) or .dat (of an exported
    /// deck) of CalculiX.
    #[arg(required = true, value_name = "ANSWER")]
    pub answers: Vec<PathBuf>,
    /// Which column or field holds what, such as pressure=CPRESS; a component of a field by its number from 0 or its
    /// name, such as pressure=CONTACT:3 or pressure=S:yy; may be given several times.
    #[arg(long, value_name = "ROLE=NAME")]
    column: Vec<String>,
    /// Unit of a column or field that does not say it, such as pressure=Pa; may be given several times; another than
    /// the file says is refused.
    #[arg(long, value_name = "ROLE=UNIT")]
    unit: Vec<String>,
    /// Order of the contact edges: 1, every point is a corner (unless the file says otherwise); 2, corners and
    /// mid-sides by turns. Forces of which neither order nor areas are told have the order by which their pressures
    /// vary less, which is said.
    #[arg(long, value_parser = choice(Order::TOLD))]
    order: Option<Order>,
    /// Contact that the answers are of, in a scene with several: the others are then not missed.
    #[arg(long, value_name = "NAME")]
    contact: Option<String>,
    /// Pressures and forces are negative in compression; whole stresses always are.
    #[arg(long)]
    tension_positive: bool,
    /// Time of the state that is judged, of a .frd, .dat or .pvd with several; the last one where neither it nor the
    /// step is given.
    #[arg(long, value_name = "TIME")]
    time: Option<f64>,
    /// Step at whose end the state is that is judged, of a .frd.
    #[arg(long, value_name = "STEP")]
    step: Option<usize>,
    /// Relative error that is accepted, such as "0.1 %"; 1 % by default.
    #[arg(long, value_name = "PERCENT", allow_hyphen_values = true)]
    tolerance: Option<String>,
    /// The answers are a series of meshes, coarse to fine: print observed orders, the limit by Richardson's
    /// extrapolation with its error bar, and whether it goes to the truth.
    #[arg(long, conflicts_with_all = ["markdown", "plot"])]
    pub series: bool,
    /// Draw the profile on the truth, with the differences, as SVG; of one answer.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
    /// Write every check as a test case of JUnit XML, which hosts of workflows show.
    #[arg(long, value_name = "FILE.xml")]
    pub junit: Option<PathBuf>,
    /// Replace a file that is no earlier drawing or report; files that are read are never replaced.
    #[arg(long)]
    force: bool,
    /// Print the verdicts as JSON, a line an answer.
    #[arg(long)]
    pub json: bool,
    /// Print the verdicts as Markdown.
    #[arg(long, conflicts_with = "json")]
    pub markdown: bool,
}

impl Arguments {
    /// How files are to be read.
    pub fn asked(&self) -> Result<Asked, Error> {
        let columns = self.column.iter().map(|text| Asked::pair("--column", text)).collect::<Result<Vec<_>, _>>()?;
        let units = self.unit.iter().map(|text| Asked::unit_of(text)).collect::<Result<Vec<_>, _>>()?;
        refuse_twice("--column", &columns)?;
        refuse_twice("--unit", &units)?;
        Ok(Asked {
            columns,
            units,
            order: self.order,
            contact: self.contact.clone(),
            tension_positive: self.tension_positive,
            time: self.time,
            step: self.step,
        })
    }

    /// Refuses what cannot be drawn or compared.
    pub fn refuse(&self) -> Result<(), Error> {
        let count = self.answers.len();
        if self.series && count < 3 {
            let remedy = "name three or more, coarse to fine";
            return Err(Error::value("judge", "--series", count, "three answers are needed", remedy));
        }
        writable::refuse_ending("judge", "--junit", &self.junit, ["xml", "JUnit reports are XML", ""])?;
        let Some(path) = &self.plot else { return Ok(()) };
        if count > 1 {
            return Err(Error::value("judge", "--plot", path.display(), "one answer is drawn", "name one answer"));
        }
        writable::refuse_plot("judge", &self.plot)
    }

    /// Refuses a drawing or a report that cannot be written, or by which something would be lost.
    pub fn refuse_unwritable(&self, case: &Case) -> Result<(), Error> {
        let inputs = [self.answers.clone(), case.read_files()].concat();
        let plot = Output::of("--plot", &self.plot, drawing::is_drawing);
        let junit = Output::of("--junit", &self.junit, told::is_report);
        writable::refuse("judge", [plot, junit], &inputs, self.force)
    }

    /// The tolerance asked for.
    pub fn tolerance(&self) -> Result<f64, Error> {
        let Some(text) = &self.tolerance else { return Ok(ENGINEERING) };
        let refused = |expected| Error::value("judge", "--tolerance", text, expected, accuracy::remedy());
        accuracy::percentage(text).map_err(refused)
    }
}

/// Refuses a role that is named twice, and not alike.
fn refuse_twice(option: &str, named: &[(Role, String)]) -> Result<(), Error> {
    for (k, (role, name)) in named.iter().enumerate() {
        if let Some((_, other)) = named[..k].iter().find(|(known, other)| known == role && other != name) {
            let message = format!("{option} names {} `{other}` and `{name}`", role.name());
            return Err(Error::at("judge", message, format!("leave out one {option} of the two")));
        }
    }
    Ok(())
}
