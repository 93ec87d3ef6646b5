//! VTU files as other programs write them: arrays as text, binary or appended, in base64 or raw, compressed by zlib or
//! not. `vtkio` 0.7.0-rc2, which writes ours, refuses raw appended data (NGSolve, and VTK by default: "unknown variant
//! `raw`"; the feature `binary` by which it reads them is not declared), takes a last block that is full for none
//! ("DataArraySizeMismatch { expected: 4, actual: 0 }"), and panics where a file is cut.

use std::borrow::Cow;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;

use crate::error::Error;
use crate::referee::unstructured::{Field, Grid};

/// What to do with a file that is not read.
pub const AGAIN: &str = "save it as a VTK unstructured grid (.vtu) in one piece, little endian, its arrays as text, \
    plain or compressed by zlib";
/// Most bytes of an array.
const LARGEST: u64 = 64 << 20;
/// Parts of a piece that hold arrays.
const PARTS: [&str; 5] = ["<PointData", "<CellData", "<Points", "<Cells", "<FieldData"];

/// The grid of a file.
pub fn parse<'a>(file: &'a Path, bytes: &[u8]) -> Result<Grid<'a>, Error> {
    let refused = |why: String| Error::unreadable(file, why, AGAIN);
    let coding = Coding::of(bytes).map_err(|why| refused(why.into()))?;
    let appended = tag(bytes, b"<AppendedData", 0);
    let body = &uncommented(&bytes[..appended.as_ref().map_or(bytes.len(), |tag| tag.start)])[..];
    let piece = tag(body, b"<Piece", 0).filter(|piece| tag(body, b"<Piece", piece.end).is_none());
    let piece = piece.ok_or_else(|| refused("it has not one piece".into()))?;
    let piece = String::from_utf8_lossy(&body[piece]).into_owned();
    let count = attribute(&piece, "NumberOfPoints").and_then(|count| count.trim().parse::<usize>().ok());
    let mut grid = Grid::of(file);
    let (mut at, mut part) = (0, "");
    while let Some(found) = tag(body, b"<DataArray", at) {
        let begun = PARTS.iter().filter_map(|part| Some((last(&body[at..found.start], part)?, *part))).max();
        part = begun.map_or(part, |(_, part)| part);
        let array = String::from_utf8_lossy(&body[found.clone()]).into_owned();
        let [name, kind] = ["Name", "type"].map(|key| attribute(&array, key).unwrap_or_default());
        let empty = array.ends_with('/');
        let end = if empty { Some(found.end) } else { position(body, b"</DataArray", found.end) };
        let end = end.ok_or_else(|| refused(format!("its array `{name}` has no end")))?;
        // What VTK knows of an array, as its range, stands behind its numbers.
        let inside = body.get(found.end + 1..end).unwrap_or_default().split(|byte| *byte == b'<').next();
        let inside = inside.unwrap_or_default();
        at = end;
        // Other fields than numbers, and those of cells, are not read.
        let is_time = (part, name) == ("<FieldData", "TimeValue");
        if ["<CellData", "<FieldData"].contains(&part) && !is_time || kind == "String" {
            continue;
        }
        let numbers = match (attribute(&array, "format").unwrap_or("ascii"), &appended) {
            ("binary", _) if !empty => coding.decoded(&unpadded(inside), kind),
            ("appended", Some(place)) => {
                let offset = attribute(&array, "offset").and_then(|offset| offset.parse::<usize>().ok());
                coding.appended(bytes, place, offset.unwrap_or(usize::MAX), kind)
            }
            _ => as_words(inside),
        };
        let data = numbers.map_err(|why| refused(format!("its array `{name}` {why}")))?;
        put(&mut grid, part, &array, data).map_err(refused)?;
    }
    match count {
        Some(count) if Some(grid.points.len()) == count.checked_mul(3) => Ok(grid),
        _ => Err(refused(format!(
            "it has {} coordinates, which are not those of the points it announces",
            grid.points.len()
        ))),
    }
}

/// Puts the numbers of an array, whose tag is given, where they belong by the part of the file that it stands in.
fn put(grid: &mut Grid, part: &str, array: &str, data: Vec<f64>) -> Result<(), String> {
    let name = attribute(array, "Name").unwrap_or_default();
    let index = |value: &f64| if *value >= 0.0 { *value as usize } else { usize::MAX };
    match (part, name) {
        ("<FieldData", _) => grid.time = data.last().copied(),
        ("<Points", _) => grid.points = data,
        ("<Cells", "connectivity") => grid.connectivity = data.iter().map(index).collect(),
        ("<Cells", "offsets") => grid.ends = data.iter().map(index).collect(),
        ("<Cells", "types") => grid.types = data.iter().map(|kind| *kind as u8).collect(),
        ("<PointData", _) => {
            let number = |number: &str| number.trim().parse().ok();
            let components = attribute(array, "NumberOfComponents").map_or(Some(1), number);
            let components = components.ok_or_else(|| format!("`{name}` has no number of components"))?;
            let names =
                (0..components.min(9)).map(|k| attribute(array, &format!("ComponentName{k}")).unwrap_or_default());
            let names = names.map(str::to_owned).collect();
            grid.fields.push(Field { name: unescaped(name), components, names, data });
        }
        _ => {}
    }
    Ok(())
}

/// Where a part begins last: its name, and no longer one.
fn last(bytes: &[u8], part: &str) -> Option<usize> {
    let is_it = |window: &[u8]| window.starts_with(part.as_bytes()) && !window[part.len()].is_ascii_alphabetic();
    bytes.windows(part.len() + 1).rposition(is_it)
}

/// Numbers that are written out.
fn as_words(text: &[u8]) -> Result<Vec<f64>, String> {
    let text = String::from_utf8_lossy(text);
    let number = |word: &str| word.parse().map_err(|_| format!("has the word `{word}`, which is no number"));
    text.split_whitespace().map(number).collect()
}

/// The next tag of a name: from its first mark to its `>`, which is left out.
pub fn tag(bytes: &[u8], name: &[u8], from: usize) -> Option<Range<usize>> {
    let begin = position(bytes, name, from)?;
    Some(begin..position(bytes, b">", begin)?)
}

/// The same with blanks in place of what is commented out.
pub fn uncommented(bytes: &[u8]) -> Cow<'_, [u8]> {
    let (mut plain, mut at) = (Cow::Borrowed(bytes), 0);
    while let Some(begin) = position(bytes, b"<!--", at) {
        at = position(bytes, b"-->", begin + 4).map_or(bytes.len(), |end| end + 3);
        plain.to_mut()[begin..at].fill(b' ');
    }
    plain
}

fn position(bytes: &[u8], wanted: &[u8], from: usize) -> Option<usize> {
    bytes.get(from..)?.windows(wanted.len()).position(|window| window == wanted).map(|at| from + at)
}

/// The value of an attribute of a tag.
pub fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let behind = |at: usize| tag[at + name.len()..].trim_start().strip_prefix('=');
    let is_key = |at: &usize| tag[..*at].ends_with(char::is_whitespace) && behind(*at).is_some();
    let rest = behind(tag.match_indices(name).map(|(at, _)| at).find(is_key)?)?.trim_start();
    let mark = rest.chars().next().filter(|mark| ['"', '\''].contains(mark))?;
    rest[1..].split_once(mark).map(|(value, _)| value)
}

/// What an attribute says: XML has names of its own for some marks.
pub fn unescaped(value: &str) -> String {
    let marks = [("&quot;", "\""), ("&apos;", "'"), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")];
    marks.into_iter().fold(value.to_owned(), |text, (name, mark)| text.replace(name, mark))
}

/// Base64 with padding anywhere: four letters at a time. Nothing of what is no base64.
fn unpadded(letters: &[u8]) -> Vec<u8> {
    let letters: Vec<u8> = letters.iter().copied().filter(|letter| !letter.is_ascii_whitespace()).collect();
    let four = |four: &[u8]| STANDARD.decode(four).unwrap_or_default();
    letters.chunks_exact(4).flat_map(four).collect()
}

/// How arrays are coded.
struct Coding {
    /// Whether words of headers have eight bytes, and not four.
    wide: bool,
    /// What blocks are compressed by; none where they are not.
    compressor: Option<String>,
}

impl Coding {
    /// That of a whole file of an unstructured grid; else why it is none that is read.
    fn of(bytes: &[u8]) -> Result<Self, &'static str> {
        let head = tag(bytes, b"<VTKFile", 0).ok_or("it has no tag <VTKFile>")?;
        let head = String::from_utf8_lossy(&bytes[head]).into_owned();
        if attribute(&head, "type") != Some("UnstructuredGrid") {
            return Err("it is no unstructured grid");
        }
        if !bytes.trim_ascii_end().ends_with(b"</VTKFile>") {
            return Err("it is cut: its last tag is not </VTKFile>");
        }
        let has = |format: &str| position(bytes, format!("format=\"{format}\"").as_bytes(), 0).is_some();
        if attribute(&head, "byte_order") == Some("BigEndian") && (has("binary") || has("appended")) {
            return Err("its numbers are big endian");
        }
        Ok(Self {
            wide: attribute(&head, "header_type") == Some("UInt64"),
            compressor: attribute(&head, "compressor").map(str::to_owned),
        })
    }

    /// An array that begins so many bytes behind the mark of the appended data.
    fn appended(&self, bytes: &[u8], place: &Range<usize>, offset: usize, kind: &str) -> Result<Vec<f64>, String> {
        let head = String::from_utf8_lossy(&bytes[place.clone()]).into_owned();
        let mark = position(bytes, b"_", place.end).ok_or("is appended, and nothing is")?;
        let begin = (mark + 1).checked_add(offset).filter(|begin| *begin < bytes.len());
        let own = &bytes[begin.ok_or("begins behind the end of the file")?..];
        if attribute(&head, "encoding") == Some("raw") {
            return self.decoded(own, kind);
        }
        let end = own.iter().position(|letter| *letter == b'<').unwrap_or(own.len());
        // What belongs to the next array is not decoded: its length is in the header.
        let length = self.encoded_length(&unpadded(&own[..end.min(HEADER)]));
        self.decoded(&unpadded(&own[..end.min(length.unwrap_or(end))]), kind)
    }

    /// Letters that an array takes at most, as its header tells.
    fn encoded_length(&self, header: &[u8]) -> Option<usize> {
        let (first, _) = self.word(header, 0).ok()?;
        let bytes = if self.compressor.is_some() {
            first.checked_mul(self.word(header, 1).ok()?.0)?.checked_add(first * 16 + 64)?
        } else {
            first.checked_add(16)?
        };
        bytes.checked_mul(2)
    }

    /// The k-th word of a header, and where the next one begins.
    fn word(&self, bytes: &[u8], k: usize) -> Result<(usize, usize), String> {
        let size = if self.wide { 8 } else { 4 };
        let own = k.checked_mul(size).and_then(|begin| bytes.get(begin..begin.checked_add(size)?));
        let own = own.ok_or("is cut in its header")?;
        let value = own.iter().rev().fold(0_u64, |sum, byte| sum << 8 | u64::from(*byte));
        Ok((usize::try_from(value).map_err(|_| "has a header too large")?, (k + 1) * size))
    }

    /// The numbers of header and data.
    fn decoded(&self, bytes: &[u8], kind: &str) -> Result<Vec<f64>, String> {
        let plain = match self.compressor.as_deref() {
            Some("vtkZLibDataCompressor") => self.inflated(bytes)?,
            Some(other) => return Err(format!("is compressed by {other}, and zlib is read")),
            None => {
                let (length, begin) = self.word(bytes, 0)?;
                begin.checked_add(length).and_then(|end| bytes.get(begin..end)).ok_or("is cut")?.to_vec()
            }
        };
        numbers(&plain, kind, false).ok_or_else(|| format!("is of the type {kind}, which is not read"))
    }

    /// All blocks, inflated: the header has their number, two sizes, and the compressed size of each.
    fn inflated(&self, bytes: &[u8]) -> Result<Vec<u8>, String> {
        let (blocks, _) = self.word(bytes, 0)?;
        if blocks == 0 {
            return Ok(vec![]);
        }
        // The header holds a word a block.
        let (_, mut begin) = self.word(bytes, blocks.checked_add(2).ok_or("has a header too large")?)?;
        let mut plain = Vec::new();
        for block in 0..blocks {
            let (length, _) = self.word(bytes, 3 + block)?;
            let end = begin.checked_add(length).ok_or("has a header too large")?;
            let own = bytes.get(begin..end).ok_or("is cut")?;
            let room = (LARGEST + 1).saturating_sub(plain.len() as u64);
            ZlibDecoder::new(own)
                .take(room)
                .read_to_end(&mut plain)
                .map_err(|error| format!("cannot be inflated: {error}"))?;
            if plain.len() as u64 > LARGEST {
                return Err(format!("has more than {LARGEST} bytes"));
            }
            begin = end;
        }
        Ok(plain)
    }
}

/// Letters that hold the two first words of any header.
const HEADER: usize = 24;

/// Numbers of a type, their bytes from the smallest on or from the largest; none where it is not known.
pub fn numbers(bytes: &[u8], kind: &str, big: bool) -> Option<Vec<f64>> {
    fn all<const N: usize>(bytes: &[u8], big: bool, of: fn([u8; N]) -> f64) -> Vec<f64> {
        let turned = |mut chunk: [u8; N]| {
            chunk.reverse();
            chunk
        };
        bytes.as_chunks::<N>().0.iter().map(|chunk| of(if big { turned(*chunk) } else { *chunk })).collect()
    }
    Some(match kind {
        "Float32" => all(bytes, big, |b| f32::from_le_bytes(b).into()),
        "Float64" => all(bytes, big, f64::from_le_bytes),
        "Int8" => all(bytes, big, |b| i8::from_le_bytes(b).into()),
        "UInt8" => all(bytes, big, |b| u8::from_le_bytes(b).into()),
        "Int16" => all(bytes, big, |b| i16::from_le_bytes(b).into()),
        "UInt16" => all(bytes, big, |b| u16::from_le_bytes(b).into()),
        "Int32" => all(bytes, big, |b| i32::from_le_bytes(b).into()),
        "UInt32" => all(bytes, big, |b| u32::from_le_bytes(b).into()),
        "Int64" => all(bytes, big, |b| i64::from_le_bytes(b) as f64),
        "UInt64" => all(bytes, big, |b| u64::from_le_bytes(b) as f64),
        _ => return None,
    })
}
