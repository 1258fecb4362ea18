#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| caustic_fuzz::recording::run(bytes));
