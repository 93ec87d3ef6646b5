//! Reads whatever bytes as answers of another code.
#![no_main]

#[path = "../read.rs"]
mod read;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::tell(read::answers(bytes)));
