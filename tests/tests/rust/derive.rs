//! What a user sees who writes the derive rightly or wrongly.

#[test]
fn the_derive_compiles_or_says_why_not() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/rust/ui/good.rs");
    cases.pass("tests/rust/ui/renamed.rs");
    cases.compile_fail("tests/rust/ui/no_path.rs");
    cases.compile_fail("tests/rust/ui/missing.rs");
    cases.compile_fail("tests/rust/ui/private.rs");
    cases.compile_fail("tests/rust/ui/typo.rs");
    cases.compile_fail("tests/rust/ui/wrong_access.rs");
}
