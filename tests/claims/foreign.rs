//! Answers as other programs write them: tables and fields of CalculiX, grids of VTK.

use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::ellipse::{NODES, gap, place, pressure};

/// A table of a `.dat`: nodes, and their forces along x.
pub fn forces(set: &str, time: &str, rows: impl IntoIterator<Item = (usize, f64)>) -> String {
    let row = |(node, force): (usize, f64)| format!("{node:>10} {force:e} 0.0 0.0\n");
    let rows: String = rows.into_iter().map(row).collect();
    format!(" forces (fx,fy,fz) for set {set} and time  {time}\n\n{rows}")
}

/// The numbers of a line of a `.frd`.
pub fn fixed<const N: usize>(numbers: [f64; N]) -> String {
    numbers.map(|x| format!("{x:>12.5E}")).concat()
}

/// A line of a `.frd`: a node and its numbers.
pub fn record(node: usize, numbers: &str) -> String {
    format!(" -1{node:>10}{numbers}\n")
}

/// A cell of a `.frd`.
pub fn cell_of(number: usize, kind: usize, nodes: &[usize]) -> String {
    let nodes: String = nodes.iter().map(|node| format!("{node:>10}")).collect();
    format!(" -1{number:>10}{kind:>5}    0    1\n -2{nodes}\n")
}

/// Nodes of two rows, and cells between them; every second one is turned round.
fn mesh() -> (Vec<[f64; 2]>, Vec<[usize; 4]>) {
    let points = (0..2 * NODES).map(|k| [place(k % NODES), 0.5 * (k / NODES) as f64]).collect();
    let cell = |k: usize| {
        let [a, b, c, d] = [k, k + 1, k + 1 + NODES, k + NODES];
        if k.is_multiple_of(2) { [a, b, c, d] } else { [a, d, c, b] }
    };
    (points, (0..NODES - 1).map(cell).collect())
}

/// Legacy VTK files.
pub mod vtk {
    use crate::ellipse::{NODES, gap, place, pressure};

    use super::mesh;

    /// The ellipse in version 5.1.
    pub fn plain() -> String {
        points(&|x, y| [x, y])
    }

    /// With pressures as they are written.
    pub fn ascii(written: &dyn Fn(f64) -> String) -> String {
        text(true, &|x, y| [x, y], written)
    }

    /// With points elsewhere.
    pub fn points(moved: &dyn Fn(f64, f64) -> [f64; 2]) -> String {
        text(true, moved, &|s| format!("{:e}", pressure(s)))
    }

    /// What of a node the two rows have: the lower one is the contact side.
    fn of(k: usize, own: &dyn Fn(f64) -> String) -> String {
        if k < NODES { own(place(k)) } else { "0".into() }
    }

    pub fn text(new: bool, moved: &dyn Fn(f64, f64) -> [f64; 2], written: &dyn Fn(f64) -> String) -> String {
        let (points, cells) = mesh();
        let list = |all: Vec<String>| all.join("\n") + "\n";
        let places = points.iter().map(|[x, y]| moved(*x, *y)).map(|[x, y]| format!("{x:e} {y:e} 0")).collect();
        let nodes: Vec<String> = cells.iter().map(|cell| cell.map(|node| node.to_string()).join(" ")).collect();
        let (count, number) = (cells.len(), points.len());
        let cells = match new {
            true => {
                let ends = (0..=count).map(|k| (4 * k).to_string()).collect::<Vec<_>>().join(" ");
                let sizes = format!("CELLS {} {}\n", count + 1, 4 * count);
                format!("{sizes}OFFSETS vtktypeint64\n{ends}\nCONNECTIVITY vtktypeint64\n{}", list(nodes))
            }
            false => format!(
                "CELLS {count} {}\n{}",
                5 * count,
                list(nodes.iter().map(|nodes| format!("4 {nodes}")).collect())
            ),
        };
        let head = format!("# vtk DataFile Version {}\nof two rows\nASCII\n", if new { "5.1" } else { "3.0" });
        let grid = format!("DATASET UNSTRUCTURED_GRID\nPOINTS {number} double\n{}{cells}", list(places));
        let types = format!("CELL_TYPES {count}\n{}", "9\n".repeat(count));
        let pressures = list((0..number).map(|k| of(k, written)).collect());
        // Stresses of six and nine components, of which −σ_yy is the pressure; a vector, and a gap behind them.
        let six =
            list((0..number).map(|k| format!("7 {} 5 3 2 1", of(k, &|s| format!("{:e}", -pressure(s))))).collect());
        let gaps = list((0..number).map(|k| of(k, &|s| format!("{:e}", gap(s)))).collect());
        let before =
            format!("CELL_DATA {count}\nSCALARS pressure double\nLOOKUP_TABLE default\n{}", "3\n".repeat(count));
        let meta = "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n";
        format!(
            "{head}{grid}{types}{before}POINT_DATA {number}\nSCALARS contact_pressure double 1\nLOOKUP_TABLE \
            default\n{pressures}{meta}\
             VECTORS moved float\n{}FIELD FieldData 2\nS 6 {number} double\n{six}{meta}contact%20gap 1 {number} \
             float\n{gaps}",
            "1 2 3\n".repeat(number)
        )
    }

    /// The same in binary, of either version.
    pub fn binary(new: bool) -> Vec<u8> {
        let (points, cells) = mesh();
        let (count, number) = (cells.len(), points.len());
        let mut all = format!("# vtk DataFile Version {}\n-\nBINARY\n", if new { "5.1" } else { "3.0" }).into_bytes();
        let line = |all: &mut Vec<u8>, line: String| all.extend(format!("\n{line}\n").bytes());
        line(&mut all, format!("DATASET UNSTRUCTURED_GRID\nPOINTS {number} float"));
        all.extend(points.iter().flat_map(|[x, y]| [*x as f32, *y as f32, 0.0]).flat_map(f32::to_be_bytes));
        if new {
            line(&mut all, format!("CELLS {} {}\nOFFSETS vtktypeint64", count + 1, 4 * count));
            all.extend((0..=count as i64).flat_map(|k| (4 * k).to_be_bytes()));
            line(&mut all, "CONNECTIVITY vtktypeint64".into());
            all.extend(cells.iter().flatten().flat_map(|node| (*node as i64).to_be_bytes()));
        } else {
            line(&mut all, format!("CELLS {count} {}", 5 * count));
            let ints = cells.iter().flat_map(|cell| std::iter::once(4).chain(cell.map(|node| node as i32)));
            all.extend(ints.flat_map(i32::to_be_bytes));
        }
        line(&mut all, format!("CELL_TYPES {count}"));
        all.extend((0..count).flat_map(|_| 9_i32.to_be_bytes()));
        line(&mut all, format!("POINT_DATA {number}\nSCALARS contact_pressure double\nLOOKUP_TABLE default"));
        let of = |k: usize, own: fn(f64) -> f64| if k < NODES { own(place(k)) } else { 0.0 };
        all.extend((0..number).flat_map(|k| of(k, pressure).to_be_bytes()));
        line(&mut all, format!("FIELD FieldData 1\ngap 1 {number} double"));
        all.extend((0..number).flat_map(|k| of(k, gap).to_be_bytes()));
        all
    }
}

/// A file of fields of CalculiX on the same mesh.
pub struct Frd {
    /// How numbers are written.
    pub number: fn(f64) -> String,
    /// Nodes of the contact side that its block lists.
    pub listed: Vec<usize>,
    /// Whether cells are expanded into bricks.
    pub slice: bool,
    /// The layer whose nodes the contact block names: those of the plane, or those behind them.
    pub layer: usize,
    /// How far the nodes behind lie off along x.
    pub skew: f64,
    /// How far some nodes of the contact side lie off the path.
    pub warp: f64,
    /// How far all nodes lie off along y.
    pub below: f64,
    /// The unit of places \[mm\].
    pub length: f64,
    /// Step, increment, time and share of the pressures.
    pub states: Vec<(usize, usize, f64, f64)>,
}

impl Frd {
    pub fn plain() -> Self {
        Self {
            number: |x| format!("{x:>12.5E}"),
            listed: (0..NODES).collect(),
            slice: false,
            layer: 0,
            skew: 0.0,
            warp: 0.0,
            below: 0.0,
            length: 1.0,
            states: vec![(1, 1, 1.0, 1.0)],
        }
    }

    /// A number as C writes it, with so many digits of the exponent, and no blank before it.
    pub fn exponent(x: f64, digits: usize) -> String {
        let text = format!("{x:.5E}");
        let (mantissa, exponent) = text.split_once('E').expect("an exponent");
        let exponent: i32 = exponent.parse().expect("a number");
        format!("{mantissa}E{}{:0digits$}", if exponent < 0 { '-' } else { '+' }, exponent.abs())
    }

    pub fn text(&self) -> String {
        let (points, cells) = mesh();
        let row =
            |node: usize, numbers: &[f64]| record(node, &numbers.iter().map(|x| (self.number)(*x)).collect::<String>());
        let mut text =
            String::from("    1C\n    2C                           100                                     1\n");
        for layer in 0..if self.slice || self.layer > 0 { 2 } else { 1 } {
            for (k, [x, y]) in points.iter().enumerate() {
                let off = if k < NODES && (0.7..1.5).contains(x) { self.warp } else { 0.0 };
                let place = [x + layer as f64 * self.skew, y + off + self.below, layer as f64];
                text += &row(k + 1 + 100 * layer, &place.map(|x| x / self.length));
            }
        }
        text += " -3\n    3C                            24                                     1\n";
        for (k, cell) in cells.iter().enumerate() {
            let [nodes, behind] = [1, 101].map(|first| cell.map(|node| node + first));
            text += &if self.slice { cell_of(k + 1, 1, &[nodes, behind].concat()) } else { cell_of(k + 1, 9, &nodes) };
        }
        text += " -3\n";
        for (k, (step, increment, time, share)) in self.states.iter().enumerate() {
            text += &format!("    1PSTEP{:>26}{increment:>12}{step:>12}\n", k + 1);
            text += &format!("  100CL  101{time:>12.5E}{:>12}{:>22}{:>5}           1\n", 50, 0, k + 1);
            text += " -4  CONTACT     6    1\n";
            let names = ["COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"];
            text += &names.map(|name| format!(" -5  {name:<12}1    4    1    1\n")).concat();
            for node in &self.listed {
                let s = place(*node);
                text += &row(node + 1 + 100 * self.layer, &[gap(s), 7.0, 5.0, share * pressure(s), 3.0, 2.0]);
            }
            text += " -3\n";
        }
        text + " 9999\n"
    }
}

/// Grids in XML.
pub mod vtu {
    /// An array that is written out, with what VTK knows of it behind its numbers.
    pub fn array(kind: &str, name: &str, components: usize, numbers: &str) -> String {
        let several = if components > 1 { format!("NumberOfComponents=\"{components}\" ") } else { String::new() };
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" {several}format=\"ascii\">\n{numbers}\n<InformationKey \
            name=\"L2_NORM_RANGE\" location=\"vtkDataArray\" length=\"2\">\n<Value \
            index=\"0\">0</Value>\n</InformationKey>\n</DataArray>\n"
        )
    }

    /// A grid of quadrilaterals with four or eight nodes, and fields at its points.
    pub fn text(points: &[[f64; 3]], cells: &[Vec<usize>], fields: &str) -> String {
        let list = |numbers: &mut dyn Iterator<Item = String>| numbers.collect::<Vec<_>>().join(" ");
        let places = list(&mut points.iter().map(|[x, y, z]| format!("{x:e} {y:e} {z:e}")));
        let nodes = list(&mut cells.iter().flatten().map(usize::to_string));
        let ends = list(&mut (1..=cells.len()).map(|k| cells[..k].concat().len().to_string()));
        let types = list(&mut cells.iter().map(|cell| if cell.len() == 4 { "9" } else { "23" }.into()));
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
            header_type=\"UInt32\" compressor=\"vtkLZ4DataCompressor\">\n<UnstructuredGrid>\n<Piece \
            NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n\
            <PointData>\n{fields}</PointData>\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n</Piece>\n\
            </UnstructuredGrid>\n</VTKFile>\n",
            points.len(),
            cells.len(),
            array("Float64", "Points", 3, &places),
            array("Int64", "connectivity", 1, &nodes),
            array("Int64", "offsets", 1, &ends),
            array("UInt8", "types", 1, &types),
        )
    }
}

/// A grid whose arrays are coded in one of VTK's ways: appended or in line, raw or in base64, compressed or not,
/// headers of 4 or 8 bytes.
pub fn coded(appended: bool, raw: bool, zlib: bool, wide: bool, ints: &str) -> Vec<u8> {
    let (points, cells) = mesh();
    let at = |own: fn(f64) -> f64| (0..2 * NODES).map(|k| if k < NODES { own(place(k)) } else { 0.0 }).collect();
    let floats = |all: Vec<f64>| all.into_iter().flat_map(f64::to_le_bytes).collect::<Vec<u8>>();
    let whole = |all: Vec<usize>| {
        let bytes = |node: usize| match ints {
            "UInt16" => (node as u16).to_le_bytes().to_vec(),
            "Int16" => (node as i16).to_le_bytes().to_vec(),
            "UInt32" => (node as u32).to_le_bytes().to_vec(),
            "UInt64" => (node as u64).to_le_bytes().to_vec(),
            _ => (node as i32).to_le_bytes().to_vec(),
        };
        all.into_iter().flat_map(bytes).collect::<Vec<u8>>()
    };
    let ends = (1..=cells.len()).map(|k| 4 * k).collect();
    let arrays = [
        ("<PointData>", "contact_pressure", "Float64", 1, floats(at(pressure))),
        ("", "gap", "Float64", 1, floats(at(gap))),
        (
            "</PointData><Points>",
            "Points",
            "Float64",
            3,
            floats(points.iter().flat_map(|[x, y]| [*x, *y, 0.0]).collect()),
        ),
        ("</Points><Cells>", "connectivity", ints, 1, whole(cells.iter().flatten().copied().collect())),
        ("", "offsets", ints, 1, whole(ends)),
        ("", "types", "Int8", 1, vec![9; cells.len()]),
    ];
    let word =
        |word: usize| if wide { (word as u64).to_le_bytes().to_vec() } else { (word as u32).to_le_bytes().to_vec() };
    let code = |bytes: &[u8]| {
        // Two blocks, of which the last is not full; or so small ones that each is longer when it is compressed.
        let size = if wide { 7 } else { bytes.len() / 8 / 2 * 8 + 8 };
        let packed: Vec<Vec<u8>> = bytes
            .chunks(size)
            .map(|block| {
                let mut all = ZlibEncoder::new(Vec::new(), Compression::default());
                all.write_all(block).and_then(|()| all.finish()).expect("compressed")
            })
            .collect();
        let sizes: Vec<usize> = packed.iter().map(Vec::len).collect();
        let (head, body) = match zlib {
            true => ([vec![packed.len(), size, bytes.len() % size], sizes].concat(), packed.concat()),
            false => (vec![bytes.len()], bytes.to_vec()),
        };
        let head: Vec<u8> = head.into_iter().flat_map(word).collect();
        match (raw, zlib) {
            (true, _) => [head, body].concat(),
            (false, true) => (STANDARD.encode(head) + &STANDARD.encode(body)).into_bytes(),
            (false, false) => STANDARD.encode([head, body].concat()).into_bytes(),
        }
    };
    let [width, packer] =
        [if wide { "UInt64" } else { "UInt32" }, if zlib { " compressor=\"vtkZLibDataCompressor\"" } else { "" }];
    let mut text = format!(
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
        header_type=\"{width}\"{packer}><UnstructuredGrid>\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
        points.len(),
        cells.len()
    )
    .into_bytes();
    let mut behind = Vec::new();
    for (before, name, kind, components, bytes) in arrays {
        let own = code(&bytes);
        let head = format!("{before}<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\"");
        match appended {
            true => text.extend(format!("{head} format=\"appended\" offset=\"{}\"/>", behind.len()).bytes()),
            false => text.extend([format!("{head} format=\"binary\">").as_bytes(), &own, b"</DataArray>"].concat()),
        }
        behind.extend(own);
    }
    text.extend(b"</Cells></Piece></UnstructuredGrid>");
    if appended {
        let encoding = if raw { "raw" } else { "base64" };
        text.extend(
            [format!("<AppendedData encoding=\"{encoding}\">_").as_bytes(), &behind, b"</AppendedData>"].concat(),
        );
    }
    text.extend(b"</VTKFile>");
    text
}
