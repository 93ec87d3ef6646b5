//! Files of the legacy VTK format, up to version 5.1, ASCII or binary, as ParaView, meshio, FElupe and SfePy write
//! them. `vtkio` 0.7.0-rc2 refuses ASCII arrays that hold `nan`, and cells by `OFFSETS` of another type than
//! `vtktypeint64` ("Parse error: Digit" for both).

use std::path::Path;

use crate::error::Error;
use crate::referee::unstructured::{Field, Grid};
use crate::referee::vtu::{AGAIN, numbers};

/// The grid of a file.
pub fn parse<'a>(file: &'a Path, bytes: &'a [u8]) -> Result<Grid<'a>, Error> {
    let mut reader = Reader { file, bytes, at: 0, binary: false, grid: Grid::of(file), of_nodes: false };
    let head: Vec<String> = (0..3).map(|_| reader.line()).collect();
    if !head[0].starts_with("# vtk DataFile") {
        return Err(reader.refused("its first line is not that of a legacy VTK file"));
    }
    reader.binary = head[2].trim().eq_ignore_ascii_case("BINARY");
    let colours = if reader.binary { "unsigned_char" } else { "float" };
    // How many entries the arrays have.
    let mut entries = 0;
    while let Some(line) = reader.next() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let word = |k: usize| words.get(k).copied().unwrap_or_default();
        let told = |k: usize| word(k).parse::<usize>().ok();
        let here = reader.refused(&format!("`{line}` begins no part of an unstructured grid, or lacks a number"));
        let count = |k: usize| told(k).ok_or_else(|| here.clone());
        let array = |reader: &mut Reader, components| reader.array(word(1), [components, entries], word(2));
        match word(0).to_ascii_uppercase().as_str() {
            "DATASET" if word(1).eq_ignore_ascii_case("UNSTRUCTURED_GRID") => {}
            "POINTS" => reader.grid.points = reader.numbers(3, count(1)?, word(2))?,
            "CELLS" => reader.cells(count(1)?, count(2)?)?,
            "CELL_TYPES" => {
                let types = reader.numbers(1, count(1)?, "int")?;
                reader.grid.types = types.into_iter().map(|kind| kind as u8).collect();
            }
            part @ ("POINT_DATA" | "CELL_DATA") => {
                (entries, reader.of_nodes) = (count(1)?, part == "POINT_DATA");
                let points = reader.grid.points.len() / 3;
                if reader.of_nodes && entries != points {
                    return Err(reader.refused(&format!("it has data of {entries} points, and {points} points")));
                }
            }
            "METADATA" => reader.metadata(),
            "FIELD" => (0..count(2)?).try_for_each(|_| reader.field())?,
            // These are passed over.
            "LOOKUP_TABLE" => drop(reader.numbers(4, told(2).unwrap_or(0), colours)?),
            "COLOR_SCALARS" => drop(reader.numbers(count(2)?, entries, colours)?),
            "TEXTURE_COORDINATES" => drop(reader.numbers(count(2)?, entries, word(3))?),
            "SCALARS" => {
                let before = reader.at;
                let has_table = reader.next().is_some_and(|line| line.to_ascii_uppercase().starts_with("LOOKUP_TABLE"));
                reader.at = if has_table { reader.at } else { before };
                array(&mut reader, told(3).unwrap_or(1))?;
            }
            "VECTORS" | "NORMALS" => array(&mut reader, 3)?,
            "TENSORS" => array(&mut reader, 9)?,
            "TENSORS6" => array(&mut reader, 6)?,
            "GLOBAL_IDS" | "PEDIGREE_IDS" => array(&mut reader, 1)?,
            _ => return Err(here),
        }
    }
    Ok(reader.grid)
}

/// A name, in which blanks and the like are written as `%20`.
fn plain(name: &str) -> String {
    let mut parts = name.split('%');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |name, part| {
        let letter = part.get(..2).and_then(|digits| u8::from_str_radix(digits, 16).ok()).filter(u8::is_ascii);
        letter.map_or_else(|| format!("{name}%{part}"), |letter| format!("{name}{}{}", char::from(letter), &part[2..]))
    })
}

/// A file that is read from its begin on.
struct Reader<'a> {
    file: &'a Path,
    bytes: &'a [u8],
    at: usize,
    binary: bool,
    /// What was read.
    grid: Grid<'a>,
    /// Whether arrays are those of nodes.
    of_nodes: bool,
}

impl Reader<'_> {
    /// What is wrong about where it is read.
    fn refused(&self, why: &str) -> Error {
        let line = self.bytes[..self.at].iter().filter(|byte| **byte == b'\n').count() + 1;
        let place = if self.binary { format!("byte {}", self.at) } else { format!("line {line}") };
        Error::unreadable(self.file, format!("{why} (up to {place})"), AGAIN)
    }

    /// The rest of a line.
    fn line(&mut self) -> String {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|byte| *byte == b'\n').map_or(rest.len(), |end| end + 1);
        self.at += end;
        String::from_utf8_lossy(&rest[..end]).trim().to_owned()
    }

    /// The next line that is not empty; none at the end.
    fn next(&mut self) -> Option<String> {
        std::iter::from_fn(|| (self.at < self.bytes.len()).then(|| self.line())).find(|line| !line.is_empty())
    }

    /// Names of the components of the array before, where that was of nodes; what else stands there, up to an empty
    /// line, is passed over.
    fn metadata(&mut self) {
        let lines: Vec<String> = std::iter::from_fn(|| Some(self.line()).filter(|line| !line.is_empty())).collect();
        let names = lines.iter().skip_while(|line| *line != "COMPONENT_NAMES").skip(1).map(|name| plain(name));
        if let Some(field) = self.grid.fields.last_mut().filter(|field| self.of_nodes && field.names.is_empty()) {
            field.names = names.take(field.components).collect();
        }
    }

    /// Passes over a string: a line, or its letters behind their number, whose two first bits tell by how many bytes it
    /// is written.
    fn pass_over_word(&mut self) -> Result<(), Error> {
        if !self.binary && self.at < self.bytes.len() {
            self.line();
            return Ok(());
        }
        let first = self.bytes.get(self.at).copied().unwrap_or_default();
        let head =
            self.bytes.get(self.at + 1..self.at + (8 >> (first >> 6))).ok_or_else(|| self.refused("it is cut"))?;
        let length = head.iter().fold(usize::from(first & 63), |sum, byte| sum << 8 | usize::from(*byte));
        let end = self.at.saturating_add(1 + head.len()).saturating_add(length);
        self.at = Some(end).filter(|end| *end <= self.bytes.len()).ok_or_else(|| self.refused("it is cut"))?;
        Ok(())
    }

    /// Numbers of a type, so many entries with so many components.
    fn numbers(&mut self, components: usize, entries: usize, kind: &str) -> Result<Vec<f64>, Error> {
        let count = components.saturating_mul(entries);
        if self.binary {
            let (kind, size) = xml(kind);
            let end = count.checked_mul(size).and_then(|length| length.checked_add(self.at));
            let own = end.and_then(|end| self.bytes.get(self.at..end)).ok_or_else(|| self.refused("it is cut"))?;
            self.at += own.len();
            return numbers(own, kind, true).ok_or_else(|| self.refused("its numbers are of a type that is not read"));
        }
        let mut all = Vec::new();
        while all.len() < count {
            let rest = &self.bytes[self.at..];
            let begin = rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
            let length = rest[begin..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - begin);
            let word = String::from_utf8_lossy(&rest[begin..begin + length]);
            if word.is_empty() {
                return Err(self.refused("it is cut"));
            }
            self.at += begin + length;
            all.push(word.parse().map_err(|_| self.refused(&format!("`{word}` is no number")))?);
        }
        Ok(all)
    }

    /// An array, which is kept where it is of nodes.
    fn array(&mut self, name: &str, [components, entries]: [usize; 2], kind: &str) -> Result<(), Error> {
        if kind.eq_ignore_ascii_case("string") {
            return (0..components.saturating_mul(entries)).try_for_each(|_| self.pass_over_word());
        }
        let data = self.numbers(components, entries, kind)?;
        if self.grid.points.is_empty() && ["time", "timevalue"].contains(&name.to_lowercase().as_str()) {
            self.grid.time = data.last().copied();
        }
        let field = self.of_nodes.then(|| Field { name: plain(name), components, names: vec![], data });
        self.grid.fields.extend(field);
        Ok(())
    }

    /// Cells by their numbers of nodes, or since version 5.1 by where they end.
    fn cells(&mut self, count: usize, size: usize) -> Result<(), Error> {
        let index = |value: f64| if value >= 0.0 { value as usize } else { usize::MAX };
        let kind = |line: &str| line.split_whitespace().nth(1).unwrap_or_default().to_owned();
        let before = self.at;
        if let Some(line) = self.next().filter(|line| line.to_ascii_uppercase().starts_with("OFFSETS")) {
            self.grid.ends = self.numbers(1, count, &kind(&line))?.into_iter().skip(1).map(index).collect();
            let line = self.next().unwrap_or_default();
            self.grid.connectivity = self.numbers(1, size, &kind(&line))?.into_iter().map(index).collect();
            return Ok(());
        }
        self.at = before;
        let all = self.numbers(1, size, "int")?;
        let mut rest = all.as_slice();
        while let Some((length, behind)) = rest.split_first() {
            let own = behind.get(..index(*length)).ok_or_else(|| self.refused("its cells are cut"))?;
            self.grid.connectivity.extend(own.iter().copied().map(index));
            self.grid.ends.push(self.grid.connectivity.len());
            rest = &behind[own.len()..];
        }
        Ok(())
    }

    /// An array of a field: its name, components, entries and type, then its numbers.
    fn field(&mut self) -> Result<(), Error> {
        let mut line = self.next().unwrap_or_default();
        while line.starts_with("METADATA") {
            self.metadata();
            line = self.next().unwrap_or_default();
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            [name, components, entries, kind] => match [components, entries].map(|word| word.parse::<usize>()) {
                [Ok(components), Ok(entries)] => self.array(name, [components, entries], kind),
                _ => Err(self.refused(&format!("`{line}` has no numbers of components and entries"))),
            },
            _ => Err(self.refused(&format!("`{line}` is no name of an array with its numbers and type"))),
        }
    }
}

/// What a type is called in VTU files, and the bytes of a number; not known there where it is not known here.
fn xml(kind: &str) -> (&'static str, usize) {
    const TYPES: [(&str, &str, usize); 11] = [
        ("char", "Int8", 1),
        ("unsigned_char", "UInt8", 1),
        ("short", "Int16", 2),
        ("unsigned_short", "UInt16", 2),
        ("int", "Int32", 4),
        ("vtkidtype", "Int32", 4),
        ("unsigned_int", "UInt32", 4),
        ("long", "Int64", 8),
        ("unsigned_long", "UInt64", 8),
        ("float", "Float32", 4),
        ("double", "Float64", 8),
    ];
    let kind = kind.to_ascii_lowercase();
    let wide = kind.strip_prefix("vtktype").unwrap_or("none");
    let is_it = |(own, xml, _): &&(&str, &str, usize)| *own == kind || xml.eq_ignore_ascii_case(wide);
    TYPES.iter().find(is_it).map_or(("", 0), |(_, xml, size)| (*xml, *size))
}
