//! Sweeps in several processes give the same file: `cargo test --features mpi`, which needs `mpirun`.
#![cfg(feature = "mpi")]

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

use pendulum_sweep::{Arguments, Axis, Failure, Sweep};

const FILE: &str = "PENDULUM_SWEEP_MPI_FILE";
/// Environment variable: the kind of failure in the second process.
const WRONG: &str = "PENDULUM_SWEEP_MPI_WRONG";

/// Runs in the child processes of the other tests.
#[test]
fn child() -> Result<(), Box<dyn Error>> {
    let Some(path) = std::env::var_os(FILE) else {
        return Ok(());
    };
    let is_second = std::env::var("OMPI_COMM_WORLD_RANK").is_ok_and(|rank| rank == "1");
    let wrong = std::env::var(WRONG).ok().filter(|_| is_second);
    let rows = if wrong.as_deref() == Some("design") { 2000 } else { 2001 };
    let root = |[x]: [f64; 1]| match x {
        x if x > 1.0 && wrong.as_deref() == Some("abort") => std::process::abort(),
        x if x > 1.0 && wrong.as_deref() == Some("panic") => panic!("the second process"),
        x if x < 0.0 => Err(Failure::from("negative")),
        x => Ok([x.sqrt()]),
    };
    let job = Sweep::grid("roots", [Axis::linear("x", "1", -1.0, 9.0, rows)]).each([("root", "1")], root);
    Ok(job.rows_per_shard(100).quiet().obey(Arguments::default(), path)?)
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

/// Runs the test above in `ranks` processes.
fn mpirun(ranks: &str, path: &Path) -> Result<Command, Box<dyn Error>> {
    let mut command = Command::new("mpirun");
    command
        .args(["--oversubscribe", "--timeout", "60", "-n", ranks])
        .arg(std::env::current_exe()?)
        .args(["--exact", "child", "--nocapture"])
        .env(FILE, path)
        .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    Ok(command)
}

/// Runs a command that must succeed, and returns its output.
fn text_of(command: &mut Command) -> Result<String, Box<dyn Error>> {
    let output = command.output()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}{errors}");
    Ok(text)
}

#[test]
fn processes_of_mpirun_write_the_same_file() -> Result<(), Box<dyn Error>> {
    let folder = folder("mpi");
    let run = |ranks: &str| -> Result<Vec<u8>, Box<dyn Error>> {
        let path = folder.join(format!("{ranks}.parquet"));
        let text = text_of(&mut mpirun(ranks, &path)?)?;
        assert_eq!(text.matches("2001 of 2001 rows").count(), 1, "{text}");
        assert!(text.contains("of which 200 failed"), "{text}");
        Ok(std::fs::read(path)?)
    };
    let one = run("1")?;
    for ranks in ["2", "4"] {
        assert!(one == run(ranks)?, "{ranks} ranks");
    }
    Ok(())
}

#[test]
fn where_a_process_dies_all_end_and_the_next_start_goes_on() -> Result<(), Box<dyn Error>> {
    let folder = folder("mpi_dead");
    let whole = folder.join("whole.parquet");
    text_of(&mut mpirun("2", &whole)?)?;
    for wrong in ["abort", "panic"] {
        let path = folder.join(wrong).with_extension("parquet");
        let died = mpirun("2", &path)?.env(WRONG, wrong).output()?;
        assert!(!died.status.success() && !path.exists(), "{wrong}");
        let errors = String::from_utf8_lossy(&died.stderr);
        assert!(!errors.contains("timeout"), "{wrong}: {errors}");
        let text = text_of(&mut mpirun("2", &path)?)?;
        let computed = text
            .split(" of 2001 rows")
            .next()
            .and_then(|text| text.rsplit(' ').next());
        assert!(
            computed.is_some_and(|rows| rows.parse().is_ok_and(|rows: usize| rows < 2001)),
            "{text}"
        );
        assert!(std::fs::read(&whole)? == std::fs::read(path)?, "{wrong}");
    }
    Ok(())
}

#[test]
fn processes_with_another_sweep_are_refused() -> Result<(), Box<dyn Error>> {
    let path = folder("mpi_mixed").join("mixed.parquet");
    let mixed = mpirun("2", &path)?.env(WRONG, "design").output()?;
    let errors = String::from_utf8_lossy(&mixed.stderr);
    assert!(
        errors.contains("rank 1: this process has another sweep than the first one of `mpirun`"),
        "{errors}"
    );
    assert!(!mixed.status.success() && !path.exists());
    Ok(())
}
