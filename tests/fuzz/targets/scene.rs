//! Reads whatever bytes as a scene file.
#![no_main]

#[path = "../read.rs"]
mod read;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::tell(read::scene(bytes)));
