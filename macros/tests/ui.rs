//! What a user sees who writes the derive rightly or wrongly.
//!
//! The cases stand here and not with the other tests because each is built with all that its crate depends on.

#[test]
fn the_derive_compiles_or_says_why_not() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/good.rs");
    cases.pass("tests/ui/renamed.rs");
    cases.compile_fail("tests/ui/no_path.rs");
    cases.compile_fail("tests/ui/missing.rs");
    cases.compile_fail("tests/ui/private.rs");
    cases.compile_fail("tests/ui/typo.rs");
    cases.compile_fail("tests/ui/wrong_access.rs");
    cases.compile_fail("tests/ui/forbidden_image.rs");
    cases.compile_fail("tests/ui/forbidden_mapping.rs");
}
