//! The same file from several processes: `cargo test --features mpi`; `mpirun` must be there.
#![cfg(feature = "mpi")]

use std::error::Error;
use std::path::Path;
use std::process::Command;

use pendulum_sweep::{Arguments, Axis, Failure, Sweep};

const FILE: &str = "PENDULUM_SWEEP_MPI_FILE";

/// What the children of the other test do.
#[test]
fn child() -> Result<(), Box<dyn Error>> {
    let Some(path) = std::env::var_os(FILE) else {
        return Ok(());
    };
    let root = |[x]: [f64; 1]| match x {
        x if x < 0.0 => Err(Failure::from("negative")),
        x => Ok([x.sqrt()]),
    };
    let job = Sweep::grid("roots", [Axis::linear("x", "1", -1.0, 9.0, 2001)]).each([("root", "1")], root);
    Ok(job.shard(100).quiet().obey(Arguments::default(), path)?)
}

#[test]
fn processes_of_mpirun_write_the_same_file() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mpi");
    let _ = std::fs::remove_dir_all(&folder);
    let run = |ranks: &str| {
        let path = folder.join(format!("{ranks}.parquet"));
        let output = Command::new("mpirun")
            .args(["--oversubscribe", "-n", ranks])
            .arg(std::env::current_exe()?)
            .args(["--exact", "child", "--nocapture"])
            .env(FILE, &path)
            .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
            .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
            .output()?;
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(
            output.status.success(),
            "{text}{}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert_eq!(text.matches("2001 of 2001 rows").count(), 1, "{text}");
        assert!(text.contains("of which 200 failed"), "{text}");
        std::fs::read(path)
    };
    let one = run("1")?;
    for ranks in ["2", "4"] {
        assert!(one == run(ranks)?, "{ranks} ranks");
    }
    Ok(())
}
