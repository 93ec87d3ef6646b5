//! Reads whatever bytes as a mesh: of Gmsh, or a deck where they begin with a star.
#![no_main]

#[path = "../read.rs"]
mod read;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::tell(read::mesh(bytes)));
