//! An unstructured grid as files of VTK hold it: points, cells and nodal fields.

use std::path::Path;

use crate::referee::source::Source;

/// The grid of a file.
pub struct Grid<'a> {
    /// The file, of which no text is shown.
    pub source: Source<'a>,
    /// Coordinates, three a point.
    pub points: Vec<f64>,
    /// Nodes of the cells, one cell behind the other.
    pub connectivity: Vec<usize>,
    /// Where the nodes of each cell end.
    pub ends: Vec<usize>,
    /// Types of the cells, by VTK's numbers.
    pub types: Vec<u8>,
    /// Nodal fields.
    pub fields: Vec<Field>,
    /// Its time, where it says one.
    pub time: Option<f64>,
}

impl<'a> Grid<'a> {
    /// One without points.
    pub fn of(file: &'a Path) -> Self {
        let source = Source { file, text: "" };
        Self { source, points: vec![], connectivity: vec![], ends: vec![], types: vec![], fields: vec![], time: None }
    }
}

/// Numbers at the nodes.
pub struct Field {
    /// Its name.
    pub name: String,
    /// How many of them a node has.
    pub components: usize,
    /// Names of the components, empty where they have none.
    pub names: Vec<String>,
    /// The numbers, node by node.
    pub data: Vec<f64>,
}

impl Field {
    /// A number of a node.
    pub fn at(&self, node: usize, component: usize) -> f64 {
        self.data[node * self.components + component]
    }

    /// Whether its components have names; their numbers are none.
    pub fn has_names(&self) -> bool {
        self.names.iter().enumerate().any(|(k, name)| !name.is_empty() && *name != k.to_string())
    }

    /// The axes with which the name of a component ends, by letters: `xy` of `S12`, and of a stress `xx` of `SX`; else
    /// the name.
    fn axes(&self, name: &str) -> String {
        let own = name.to_lowercase();
        let axes = &own[own.trim_end_matches(['x', 'y', 'z', '1', '2', '3']).len()..];
        match (axes, axes.len()) {
            ("x" | "y" | "z", _) if self.components > 3 => axes.repeat(2),
            (_, 1) if self.components > 3 => own,
            (_, 1 | 2) => {
                let mut letters = axes.replace('1', "x").replace('2', "y").replace('3', "z").into_bytes();
                letters.sort_unstable();
                String::from_utf8_lossy(&letters).into_owned()
            }
            _ => own,
        }
    }

    /// The component of a number, from 0 as in ParaView, or of a name: one that the file gives, as it is or by its
    /// axes; where it gives none, `x` of a vector and `xy` of a stress.
    pub fn component(&self, name: &str) -> Option<usize> {
        let usual: &[&str] = match self.components {
            2 | 3 => &["x", "y", "z"],
            6 => &["xx", "yy", "zz", "xy", "yz", "xz"],
            9 => &["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"],
            _ => &[],
        };
        let is_it = |known: &String| self.axes(known) == self.axes(name);
        let named = || self.names.iter().position(|known| known == name).or_else(|| self.names.iter().position(is_it));
        let common = || usual.iter().position(|known| known.eq_ignore_ascii_case(name));
        let number = name.parse().ok().filter(|component| *component < self.components);
        number.or_else(|| if self.has_names() { named() } else { common() })
    }
}
