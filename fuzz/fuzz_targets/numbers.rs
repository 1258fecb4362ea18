#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| caustic_fuzz::numbers::run(bytes));
