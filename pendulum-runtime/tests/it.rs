//! Models at run time against compiled ones, and what they refuse.

#[path = "it/analyses.rs"]
mod analyses;
#[path = "it/compiled.rs"]
mod compiled;
#[path = "it/corpus.rs"]
mod corpus;
#[path = "it/declared.rs"]
mod declared;
#[path = "it/refused.rs"]
mod refused;
#[path = "it/robots.rs"]
mod robots;
#[path = "it/simplest.rs"]
mod simplest;
