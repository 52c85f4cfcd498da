//! The part of the page that computes, in WebAssembly: a worker of the page writes a request as JSON into the memory of
//! the module, and reads the answer, as JSON and numbers.

mod crowd;
mod drag;
mod exports;
mod frames;
mod message;
mod page;
mod start;

pub use message::{Answer, Request};
pub use page::Page;
