//! Functions in shared libraries.

use std::error::Error;
use std::path::Path;
use std::rc::Rc;

use libloading::Library;

type Run = dyn Fn(&[f64]);
type Value = dyn Fn(&[f64]) -> Vec<f64>;

/// Function that can be called.
pub(crate) struct Program {
    /// Evaluates a row of states, one after another.
    pub run: Box<Run>,
    /// Returns the results; if the function writes all results to one place, those of the last state.
    pub value: Box<Value>,
}

type Symbol = unsafe extern "C" fn(*const f64, *mut f64, std::ffi::c_long);

/// Loads the function `symbol`, which reads states of length `states` and writes `results` numbers for each.
#[allow(
    unsafe_code,
    reason = "functions of other compilers and of later runs of our own are loaded and called by address"
)]
pub(crate) fn load(library: &Path, symbol: &str, states: usize, results: usize) -> Result<Program, Box<dyn Error>> {
    // SAFETY: the library was compiled by this program; its initialisers, if any, belong to C++ globals.
    let library = unsafe { Library::new(library)? };
    // SAFETY: every loaded function has this signature: the functions of the peers are made by the template in
    // `peers/candidate.py`, the others are written out in the sources of this crate.
    let function: Symbol = unsafe { *library.get::<Symbol>(symbol.as_bytes())? };
    let library = Rc::new(library);
    let call = move |x: &[f64], out: &mut [f64]| {
        let _alive = &library;
        assert!(x.len().is_multiple_of(states) && out.len() == results);
        let count = (x.len() / states) as std::ffi::c_long;
        // SAFETY: the function reads `count` states and writes each result to the same `results` numbers, as asserted
        // above; the library outlives the closure.
        unsafe { function(x.as_ptr(), out.as_mut_ptr(), count) }
    };
    let call = Rc::new(call);
    let once = Rc::clone(&call);
    Ok(Program {
        run: Box::new(move |x| call(x, &mut vec![0.0; results])),
        value: Box::new(move |x| {
            let mut out = vec![0.0; results];
            once(x, &mut out);
            out
        }),
    })
}
