//! Where methods fail: each case is predicted first, from coefficients of the method or from the generated Jacobian, and then observed.
//!
//! The example of the same name prints all cases as a table, and draws some of them.

#[allow(dead_code, reason = "the example shows what the test does not")]
mod rows;
