//! VTU files as other programs write them, made such that their arrays are plain text: binary and appended ones, in base64 or raw, compressed by
//! zlib or not. `vtkio` 0.6, which reads the outcome, fails at the padding that meshio and VTK put between header and data. Its 0.7.0-rc2 reads
//! that, but no raw appended data (NGSolve, and VTK by default), takes a last block that is full for none, and panics where a file is cut.

use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;

use crate::error::Error;

/// What to do with a file that is not read.
pub const AGAIN: &str = "save it as a VTK unstructured grid (.vtu) in one piece, little endian, its arrays as text, plain or compressed by zlib";
/// Most bytes of an array.
const LARGEST: u64 = 64 << 20;

/// The file with all its arrays as text, and types of cells as bytes; as it is where it is no such file.
pub fn as_text<'a>(file: &Path, bytes: &'a [u8]) -> Result<Cow<'a, [u8]>, Error> {
    let refused = |why: String| Error::unreadable(file, why, AGAIN);
    let Some(head) = tag(bytes, b"<VTKFile", 0) else { return Ok(bytes.into()) };
    let head = String::from_utf8_lossy(&bytes[head.begin..head.end]).into_owned();
    let has = |format: &str| position(bytes, format!("format=\"{format}\"").as_bytes(), 0).is_some();
    if attribute(&head, "byte_order") == Some("BigEndian") && (has("binary") || has("appended")) {
        return Err(refused("its numbers are big endian".into()));
    }
    let appended = tag(bytes, b"<AppendedData", 0);
    let body = &bytes[..appended.as_ref().map_or(bytes.len(), |tag| tag.begin)];
    let coding = Coding {
        wide: attribute(&head, "header_type") == Some("UInt64"),
        zlib: match attribute(&head, "compressor") {
            None => false,
            Some("vtkZLibDataCompressor") => true,
            Some(other) => return Err(refused(format!("its arrays are compressed by {other}, and zlib is read"))),
        },
    };
    let (mut text, mut at) = (Vec::new(), 0);
    while let Some(found) = tag(body, b"<DataArray", at) {
        let array = String::from_utf8_lossy(&body[found.begin..found.end]).into_owned();
        let named = attribute(&array, "Name").unwrap_or("");
        let format = attribute(&array, "format").unwrap_or("ascii");
        text.extend_from_slice(&body[at..found.begin]);
        let end = position(body, b"</DataArray", found.end).unwrap_or(body.len());
        let empty = body[found.begin..found.end].ends_with(b"/");
        let kind = attribute(&array, "type").unwrap_or("Float64");
        let numbers = match (format, &appended) {
            ("binary", _) if !empty => Some(coding.decoded(&unpadded(&body[(found.end + 1).min(end)..end]), kind)),
            ("appended", Some(place)) => {
                let offset = attribute(&array, "offset").and_then(|offset| offset.parse::<usize>().ok());
                Some(coding.appended(bytes, place, offset.unwrap_or(usize::MAX), kind))
            }
            _ => None,
        };
        let types =
            |kind: &str| if named == "types" && kind.contains("nt") { "UInt8".to_owned() } else { kind.to_owned() };
        let tag = array.replacen(&format!("type=\"{kind}\""), &format!("type=\"{}\"", types(kind)), 1);
        match numbers {
            None => {
                text.extend_from_slice(tag.as_bytes());
                at = found.end;
            }
            Some(numbers) => {
                let numbers = numbers.map_err(|why| refused(format!("its array `{named}` {why}")))?;
                let tag = tag.replacen(&format!("format=\"{format}\""), "format=\"ascii\"", 1);
                let tag = tag.trim_end_matches('/');
                text.extend_from_slice(format!("{tag}>\n{numbers}\n</DataArray").as_bytes());
                at = if empty { found.end } else { end + b"</DataArray".len() };
            }
        }
    }
    text.extend_from_slice(&body[at.min(body.len())..]);
    if appended.is_some() {
        text.extend_from_slice(b"</VTKFile>\n");
    }
    Ok(text.into())
}

/// Where a tag begins, and where its `>` is.
struct Tag {
    begin: usize,
    end: usize,
}

fn tag(bytes: &[u8], name: &[u8], from: usize) -> Option<Tag> {
    let begin = position(bytes, name, from)?;
    Some(Tag { begin, end: position(bytes, b">", begin)? })
}

fn position(bytes: &[u8], wanted: &[u8], from: usize) -> Option<usize> {
    bytes.get(from..)?.windows(wanted.len()).position(|window| window == wanted).map(|at| from + at)
}

/// The value of an attribute of a tag.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
    rest.split_once('"').map(|(value, _)| value)
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
    /// Whether blocks are compressed by zlib.
    zlib: bool,
}

impl Coding {
    /// An array that begins so many bytes behind the mark of the appended data.
    fn appended(&self, bytes: &[u8], place: &Tag, offset: usize, kind: &str) -> Result<String, String> {
        let head = String::from_utf8_lossy(&bytes[place.begin..place.end]).into_owned();
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
        let bytes = if self.zlib {
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

    /// The numbers of header and data, as text.
    fn decoded(&self, bytes: &[u8], kind: &str) -> Result<String, String> {
        let plain = if self.zlib {
            self.inflated(bytes)?
        } else {
            let (length, begin) = self.word(bytes, 0)?;
            begin.checked_add(length).and_then(|end| bytes.get(begin..end)).ok_or("is cut")?.to_vec()
        };
        numbers(&plain, kind).ok_or_else(|| format!("is of the type {kind}, which is not read"))
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

/// Numbers as text; none of a type that is not known.
fn numbers(bytes: &[u8], kind: &str) -> Option<String> {
    fn all<const N: usize, T: ToString>(bytes: &[u8], of: fn([u8; N]) -> T) -> String {
        let (chunks, _) = bytes.as_chunks::<N>();
        chunks.iter().map(|chunk| of(*chunk).to_string()).collect::<Vec<String>>().join(" ")
    }
    Some(match kind {
        "Float32" => all(bytes, f32::from_le_bytes),
        "Float64" => all(bytes, f64::from_le_bytes),
        "Int8" => all(bytes, i8::from_le_bytes),
        "UInt8" => all(bytes, u8::from_le_bytes),
        "Int16" => all(bytes, i16::from_le_bytes),
        "UInt16" => all(bytes, u16::from_le_bytes),
        "Int32" => all(bytes, i32::from_le_bytes),
        "UInt32" => all(bytes, u32::from_le_bytes),
        "Int64" => all(bytes, i64::from_le_bytes),
        "UInt64" => all(bytes, u64::from_le_bytes),
        _ => return None,
    })
}
