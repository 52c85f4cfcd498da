//! Tests of cases in which methods fail: each case is predicted first, from coefficients of the method or from the
//! generated Jacobian, and then observed.
//!
//! The study of the same name prints all cases as a table, and draws some of them.

use testbed::where_methods_fail::row::Size;

macro_rules! holds {
    ($($name:ident: $case:path),* $(,)?) => {$(
        #[test]
        fn $name() {
            let row = $case(Size::of_build());
            assert!(row.holds(), "{row:#?}");
        }
    )*};
}

testbed::each_case!(holds);
