//! Tests that look inside.

mod equations_text;
