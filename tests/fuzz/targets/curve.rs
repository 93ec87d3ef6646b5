//! Reads whatever bytes as a digitised curve with its scene and provenance.
#![no_main]

#[path = "../read.rs"]
mod read;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::tell(read::curve(bytes)));
