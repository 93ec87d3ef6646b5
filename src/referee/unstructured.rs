//! An unstructured grid as files of VTK hold it: points, cells and nodal fields.

use std::path::Path;

/// The grid of a file.
pub struct Grid<'a> {
    /// The file.
    pub file: &'a Path,
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
        Self { file, points: vec![], connectivity: vec![], ends: vec![], types: vec![], fields: vec![], time: None }
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

    /// The component of a number, from 0 as in ParaView, or of a name: one that the file gives, as it is or behind others such as `S_XX`; where it
    /// gives none of them, `x` of a vector and `xy` of a stress.
    pub fn component(&self, name: &str) -> Option<usize> {
        let usual: &[&str] = match self.components {
            2 | 3 => &["x", "y", "z"],
            6 => &["xx", "yy", "zz", "xy", "yz", "xz"],
            9 => &["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"],
            _ => &[],
        };
        let is_it = |known: &String| {
            let own = known.to_lowercase();
            let before = own.strip_suffix(&name.to_lowercase());
            before.is_some_and(|before| ["", "s"].contains(&before) || before.ends_with(['_', '-', ' ', ':']))
        };
        let named = || self.names.iter().position(|known| known == name).or_else(|| self.names.iter().position(is_it));
        let common = || usual.iter().position(|known| known.eq_ignore_ascii_case(name));
        let found = name.parse().ok().or_else(named).or_else(common);
        found.filter(|component| *component < self.components)
    }
}
