//! Integration tests of sweeps through the public interface.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use parquet::file::reader::SerializedFileReader;
use parquet::record::RowAccessor;
use pendulum_core::control::{Pid, Sampled};
use pendulum_core::prelude::*;
use pendulum_core::stability::Lyapunov;
use pendulum_sweep::{Arguments, Axis, Draw, Ends, Failure, Job, Sweep, SweepError, Table, Task};

mechanism! {
    pub Rods {
        params { gamma: N m s = 0.1 }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: a, friction: gamma }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: b, friction: gamma }
    }
}

type Outcome = Result<(), Box<dyn Error>>;

/// Creates an empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder for tests");
    folder
}

/// Builds a model and its initial state; rejects a friction above 0.9.
fn trial([a, gamma]: [f64; 2]) -> Result<(Rods, [f64; 4]), Failure> {
    if gamma > 0.9 {
        return Err("too much friction".into());
    }
    Ok((Rods::new(RodsParams { gamma })?, [a, 0.3, 0.0, 0.0]))
}

fn method() -> Tsit5 {
    Tsit5::new()
}

type Trial = fn([f64; 2]) -> Result<(Rods, [f64; 4]), Failure>;

fn rods(rows: usize, t1: f64) -> Job<Ends<Tsit5, Trial, Rods, 4>, 2> {
    rods_of(trial, rows, t1)
}

fn draws() -> [Draw; 2] {
    [
        Draw::uniform("start", "rad", -3.0, 3.0),
        Draw::logarithmic("gamma", "N m s", 1e-3, 1.0),
    ]
}

fn rods_of(trial: Trial, rows: usize, t1: f64) -> Job<Ends<Tsit5, Trial, Rods, 4>, 2> {
    Sweep::random("rods", draws(), rows, 7)
        .ends(method(), (0.0, t1), trial)
        .value("energy", "J", |rods, t, x| rods.energy(t, x))
        .rows_per_shard(100)
        .quiet()
}

#[test]
fn rows_are_what_they_are_alone_for_any_number_of_threads_and_shares() -> Outcome {
    let folder = folder("shares");
    let table = rods(450, 2.0).run()?;
    assert_eq!(table.rows(), 450);
    let names: Vec<String> = table
        .columns()
        .iter()
        .map(|column| format!("{} {}", column.name, column.unit))
        .collect();
    let expected = "start rad, gamma N m s, t s, a rad, b rad, dot(a) rad/s, dot(b) rad/s, energy J";
    assert_eq!(names.join(", "), expected);
    for row in 0..450 {
        let (start, gamma) = (table["start"][row], table["gamma"][row]);
        let kept = ["a", "b", "dot(a)", "dot(b)", "energy"].map(|name| table[name][row].to_bits());
        match trial([start, gamma]) {
            Err(_) => {
                assert_eq!(table.failures()[&row], "too much friction");
                assert!(table["a"][row].is_nan());
            }
            Ok((model, x0)) => {
                let end = method().solve(&model, 0.0, 2.0, x0)?.end();
                let energy = model.energy(2.0, &end);
                assert_eq!(kept, [end[0], end[1], end[2], end[3], energy].map(f64::to_bits));
            }
        }
    }
    assert!(!table.failures().is_empty());

    let (whole, shared) = (folder.join("whole.parquet"), folder.join("shared.parquet"));
    let summary = rods(450, 2.0).threads(1).run_to(&whole)?;
    assert_eq!(
        (summary.rows, summary.computed, summary.failed),
        (450, 450, table.failures().len())
    );
    assert!(summary.complete);
    for share in [2, 0, 1] {
        assert!(!rods(450, 2.0).share(share, 3).run_to(&shared)?.complete);
        let merged = rods(450, 2.0).merge(&shared);
        assert_eq!(merged.is_ok(), share == 1);
        if let Err(error) = merged {
            assert!(error.to_string().contains("of 5 shards are there; shard"), "{error}");
        }
    }
    assert_eq!(fs::read(&whole)?, fs::read(&shared)?);
    assert_eq!(fs::read_dir(&folder)?.count(), 2, "no shards are left");
    let read = Table::read(&whole)?;
    let bits = |table: &Table, name: &str| table[name].iter().map(|number| number.to_bits()).collect::<Vec<_>>();
    for column in table.columns() {
        assert_eq!(bits(&table, &column.name), bits(&read, &column.name));
    }
    assert_eq!((table.columns(), table.failures()), (read.columns(), read.failures()));
    assert_eq!(table.declaration(), read.declaration());
    // an existing file is not computed again, and leftover shards of a killed job are removed
    let left = whole.with_extension("parquet.shards");
    fs::create_dir(&left)?;
    fs::write(left.join("declaration.json"), table.declaration())?;
    fs::write(left.join("000004-00000000-00000000.shard"), "")?;
    assert_eq!(rods(450, 2.0).run_to(&whole)?.computed, 0);
    assert!(!left.exists());
    Ok(())
}

#[test]
fn a_table_is_read_as_it_was_written() -> Outcome {
    let path = folder("table").join("rods.parquet");
    let table = rods(450, 1.0).run()?;
    assert!(!table.failures().is_empty());
    table.write(&path)?;
    let read = Table::read(&path)?;
    assert_eq!(format!("{table:?}"), format!("{read:?}"), "NaN included");
    Ok(())
}

/// Covers shards that end with a block of row numbers, one row before it and one after it.
#[test]
fn rows_are_numbered_across_shards() -> Outcome {
    let folder = folder("numbered");
    for shard in [1, 2, 128, 129, 130, 300] {
        let path = folder.join(format!("{shard}.parquet"));
        let job = Sweep::grid("numbers", [Axis::linear("a", "1", 0.0, 1.0, 391)]).each([("one", "1")], |_| Ok([1.0]));
        job.quiet().rows_per_shard(shard).run_to(&path)?;
        let reader = SerializedFileReader::new(fs::File::open(&path)?)?;
        let rows = reader.into_iter().map(|row| row?.get_long(0));
        assert_eq!(
            rows.collect::<Result<Vec<_>, _>>()?,
            (0..391).collect::<Vec<_>>(),
            "{shard}"
        );
    }
    Ok(())
}

/// Runs in the child processes of the next test.
#[test]
fn child() -> Outcome {
    if let Some(path) = std::env::var_os("PENDULUM_SWEEP_TEST_FILE") {
        rods(600, 1.0).rows_per_shard(20).run_to(path)?;
    }
    Ok(())
}

#[cfg(unix)]
#[test]
fn a_sweep_that_is_killed_goes_on_and_ends_with_the_same_bytes() -> Outcome {
    let folder = folder("killed");
    let (whole, killed) = (folder.join("whole.parquet"), folder.join("killed.parquet"));
    rods(600, 1.0).rows_per_shard(20).run_to(&whole)?;
    let (mut kills, mut shards) = (0, 0);
    for attempt in 0..200 {
        let mut child = Command::new(std::env::current_exe()?)
            .args(["--exact", "child"])
            .env("PENDULUM_SWEEP_TEST_FILE", &killed)
            .stdout(Stdio::null())
            .spawn()?;
        sleep(Duration::from_millis(40 + 37 * (attempt % 7)));
        if child.try_wait()?.is_none() {
            child.kill()?;
            kills += 1;
        }
        child.wait()?;
        if killed.exists() {
            break;
        }
        let complete = || {
            fs::read_dir(folder.join("killed.parquet.shards"))
                .into_iter()
                .flatten()
                .flatten()
        };
        let now = complete()
            .filter(|entry| entry.path().extension().is_some_and(|end| end == "shard"))
            .count();
        assert!(now >= shards, "shards are kept");
        shards = now;
    }
    assert!(kills > 1, "the test kills: {kills}");
    assert_eq!(fs::read(&whole)?, fs::read(&killed)?);
    Ok(())
}

/// Simulates a full disk by a limit on the file size.
#[cfg(unix)]
#[test]
fn a_full_disk_ends_in_an_error_and_the_sweep_goes_on() -> Outcome {
    let folder = folder("full");
    let (whole, full) = (folder.join("whole.parquet"), folder.join("full.parquet"));
    rods(600, 1.0).rows_per_shard(20).run_to(&whole)?;
    let kilobytes = fs::metadata(&whole)?.len() / 1024;
    for part in 1..4 {
        let limit = kilobytes * part / 4;
        let child = Command::new("bash")
            .args([
                "-c",
                &format!("trap '' XFSZ; ulimit -f {limit}; exec \"$0\" --exact child"),
            ])
            .arg(std::env::current_exe()?)
            .env("PENDULUM_SWEEP_TEST_FILE", &full)
            .output()?;
        let text = String::from_utf8(child.stdout)?;
        assert!(!child.status.success(), "{text}");
        let text = [text, String::from_utf8(child.stderr)?].concat();
        assert!(text.contains(".numbers: File too large"), "{text}");
        assert!(!full.exists());
    }
    let kept = shards(&full).len();
    assert!(kept > 0, "shards are kept");
    let summary = rods(600, 1.0).rows_per_shard(20).run_to(&full)?;
    assert_eq!(summary.computed, 600 - 20 * kept);
    assert_eq!(fs::read(&whole)?, fs::read(&full)?);
    Ok(())
}

/// Paths of the shards beside a file, in order.
fn shards(path: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(path.with_extension("parquet.shards")).expect("the folder of the shards");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "shard"))
        .collect();
    paths.sort();
    paths
}

#[test]
fn a_broken_shard_is_computed_again() -> Outcome {
    let folder = folder("broken");
    let (whole, broken) = (folder.join("whole.parquet"), folder.join("broken.parquet"));
    rods(450, 1.0).run_to(&whole)?;
    for share in 0..2 {
        rods(450, 1.0).share(share, 2).run_to(&broken)?;
    }
    // a flipped bit in the numbers, and a truncated file
    let entries = fs::read_dir(broken.with_extension("parquet.shards"))?.flatten();
    let mut paths = entries.map(|entry| entry.path());
    let numbers = paths
        .find(|path| path.extension().is_some_and(|end| end == "numbers"))
        .expect("a file");
    let mut bytes = fs::read(&numbers)?;
    let length = bytes.len();
    bytes[length / 3] ^= 4;
    fs::write(&numbers, &bytes)?;
    let last = &shards(&broken)[3];
    fs::write(last, &fs::read(last)?[..300])?;
    let missing = rods(450, 1.0).merge(&broken).expect_err("two are broken");
    assert!(
        missing.to_string().contains("3 of 5 shards are there; shard 1 "),
        "{missing}"
    );
    let summary = rods(450, 1.0).run_to(&broken)?;
    assert_eq!((summary.computed, summary.complete), (200, true));
    assert_eq!(fs::read(&whole)?, fs::read(&broken)?);
    Ok(())
}

#[test]
fn a_flipped_bit_in_a_finished_file_is_noticed() -> Outcome {
    let path = folder("flipped").join("sweep.parquet");
    let job = || rods(450, 1.0);
    job().run_to(&path)?;
    assert_eq!(job().run_to(&path)?.computed, 0);
    let whole = fs::read(&path)?;
    let mut random = 7_u64;
    let mut places: Vec<usize> = (0..300)
        .map(|_| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (random >> 33) as usize % (8 * whole.len())
        })
        .collect();
    // and bits at both ends; the metadata are at the end
    places.extend(0..64);
    places.extend((8 * (whole.len() - 400)..8 * whole.len()).step_by(3));
    let (mut numbers, mut metadata) = (0, 0);
    for place in places {
        let mut bytes = whole.clone();
        bytes[place / 8] ^= 1 << (place % 8);
        fs::write(&path, &bytes)?;
        let noticed = job().run_to(&path);
        let error = noticed
            .expect_err(&format!("bit {place} of {}", 8 * whole.len()))
            .to_string();
        assert!(error.contains("sweep.parquet"), "{error}");
        numbers += usize::from(error.contains(" in row group "));
        metadata += usize::from(error.contains("its metadata are damaged"));
    }
    assert!(numbers > 100 && metadata > 100, "{numbers} {metadata}");
    // the message names the place
    let mut bytes = whole.clone();
    // the first shard begins at offset 4096, with the column `start`
    bytes[4096 + 100] ^= 4;
    fs::write(&path, &bytes)?;
    let error = job().merge(&path).expect_err("a flipped bit").to_string();
    assert!(
        error.contains("the column `start` in row group 0, rows 0 to 99, is damaged;")
            && error.contains("run the sweep again"),
        "{error}"
    );
    // other readers check the checksums of the pages
    let error = Table::read(&path).expect_err("a flipped bit").to_string();
    assert!(error.contains("checksum"), "{error}");
    fs::write(&path, &whole)?;
    assert_eq!(job().run_to(&path)?.computed, 0);
    // a table written by hand has checksums too
    Table::read(&path)?.write(&path)?;
    assert_eq!(job().run_to(&path)?.computed, 0);
    assert_eq!(Table::read(&path)?.rows(), 450);
    Ok(())
}

#[test]
fn shards_of_different_sweeps_are_not_put_together() -> Outcome {
    let folder = folder("contradiction");
    let (one, other) = (folder.join("one.parquet"), folder.join("other.parquet"));
    rods(450, 1.0).share(0, 2).run_to(&one)?;
    rods(450, 2.0).share(1, 2).run_to(&other)?;
    for shard in shards(&other) {
        let name = shard.file_name().expect("a name").to_owned();
        fs::rename(shard, folder.join("one.parquet.shards").join(name))?;
    }
    for error in [rods(450, 1.0).merge(&one), rods(450, 1.0).run_to(&one).map(drop)] {
        let error = error.expect_err("two spans").to_string();
        assert!(
            error.contains(".shard holds another sweep;") && error.contains("task.span[1]: 2.0 in place of 1.0"),
            "{error}"
        );
    }
    assert!(!one.exists());
    assert_eq!(shards(&one).len(), 5, "nothing is removed");
    Ok(())
}

#[test]
fn another_sweep_is_not_overwritten() -> Outcome {
    let path = folder("others").join("sweep.parquet");
    rods(120, 1.0).run_to(&path)?;
    let error = rods(120, 2.0).run_to(&path).expect_err("another span");
    let text = format!(
        "{} holds another sweep; remove it, or give this one another name. It has\n  task.span[1]: 1.0 in place of 2.0",
        path.display()
    );
    assert_eq!(error.to_string(), text);
    let differs = |job: Job<_, 2>, text: &str| {
        let error = job.run_to(&path).expect_err(text).to_string();
        assert!(error.ends_with(text), "{error}");
    };
    differs(rods(120, 1.0).version("2"), "It has\n  version: \"\" in place of \"2\"");
    let heavier: Trial = |[a, gamma]| {
        let (_, start) = trial([a, gamma])?;
        Ok((Rods::new(RodsParams { gamma: 2.0 * gamma })?, start))
    };
    let twice = rods_of(heavier, 120, 1.0).run_to(&path).expect_err("another scene");
    assert!(
        twice
            .to_string()
            .contains("It has\n  task.first.derivative beside it[2]: "),
        "{twice}"
    );
    let error = rods(121, 1.0).merge(&path).expect_err("another design");
    assert!(
        error.to_string().ends_with("design.points: 120 in place of 121"),
        "{error}"
    );
    fs::write(&path, "text")?;
    assert!(matches!(Table::read(&path), Err(SweepError::File(..))));
    assert!(matches!(rods(120, 1.0).run_to(&path), Err(SweepError::File(..))));
    Ok(())
}

/// A job that calls `act` while it runs.
fn meanwhile(rows: usize, act: impl Fn() + Sync) -> Job<impl Task<1>, 1> {
    let act = move |[x]: [f64; 1]| {
        if x == 0.0 {
            act();
        }
        Ok([x])
    };
    Sweep::grid("meanwhile", [Axis::linear("x", "1", 0.0, 1.0, rows)])
        .each([("y", "1")], act)
        .rows_per_shard(10)
        .quiet()
}

#[test]
fn two_at_once_do_not_disturb_each_other() -> Outcome {
    let folder = folder("at_once");
    let [alone, path] = ["alone.parquet", "sweep.parquet"].map(|name| folder.join(name));
    meanwhile(100, || ()).run_to(&alone)?;
    let busy = |result: Result<(), SweepError>| {
        let error = result.expect_err("another process").to_string();
        let text = format!("another process is working on {};", path.display());
        assert!(error.starts_with(&text), "{error}");
    };
    // the same sweep, another one, a share, and a merge
    meanwhile(100, || {
        busy(meanwhile(100, || ()).run_to(&path).map(drop));
        busy(meanwhile(50, || ()).run_to(&path).map(drop));
        busy(meanwhile(100, || ()).share(1, 2).run_to(&path).map(drop));
        busy(meanwhile(100, || ()).merge(&path));
    })
    .run_to(&path)?;
    assert!(fs::read(&alone)? == fs::read(&path)?);
    // shares run together, but not with another sweep, nor with a process that computes all
    fs::remove_file(&path)?;
    let first = meanwhile(100, || {
        let other = meanwhile(50, || ())
            .share(1, 2)
            .run_to(&path)
            .expect_err("another sweep");
        assert!(matches!(other, SweepError::Other { .. }), "{other}");
        busy(meanwhile(100, || ()).run_to(&path).map(drop));
        busy(meanwhile(100, || ()).merge(&path));
        let second = meanwhile(100, || ())
            .share(1, 2)
            .run_to(&path)
            .expect("the other share");
        assert_eq!(second.computed, 50);
    });
    first.share(0, 2).run_to(&path)?;
    meanwhile(100, || ()).merge(&path)?;
    assert!(fs::read(&alone)? == fs::read(&path)?);
    Ok(())
}

#[test]
fn nothing_of_others_is_touched() -> Outcome {
    let folder = folder("of_others");
    let [other, path] = ["other.parquet", "sweep.parquet"].map(|name| folder.join(name));
    meanwhile(50, || ()).run_to(&other)?;
    // a file that appears while the sweep runs
    let copy = || assert!(fs::copy(&other, &path).is_ok());
    let came = meanwhile(100, copy).run_to(&path);
    assert!(matches!(came, Err(SweepError::Other { .. })));
    assert!(fs::read(&other)? == fs::read(&path)?);
    // without that file nothing is left to compute; foreign files among the shards stay
    fs::remove_file(&path)?;
    let shards = path.with_extension("parquet.shards");
    fs::write(shards.join("precious.txt"), "text")?;
    fs::write(shards.join("0-0-0.shard"), "not in this form")?;
    assert_eq!(meanwhile(100, || ()).run_to(&path)?.computed, 0);
    let left: Vec<_> = fs::read_dir(&shards)?
        .flatten()
        .map(|entry| entry.file_name())
        .collect();
    assert_eq!(left, ["precious.txt"]);
    Ok(())
}

#[test]
fn what_is_wrong_is_said() {
    let says = |result: Result<Table, SweepError>, text: &str| {
        let error = result.expect_err("an error").to_string();
        assert!(error.contains(text), "{error}");
    };
    says(rods(0, 1.0).run(), "the sweep has no points");
    let axis = |name| Axis::linear(name, "1", 0.0, 1.0, 1 << 20);
    let huge = Sweep::grid("huge", ["a", "b", "c", "d"].map(axis)).each([("one", "1")], |_| Ok([1.0]));
    says(huge.quiet().run(), "the sweep has 2^53 points or more");
    says(
        rods(10, 1.0).share(3, 3).run(),
        "shares are counted from 0, so the last one is 2",
    );
    says(
        rods(10, 1.0).value("start", "rad", |_, _, x| x[0]).run(),
        "two columns have the name `start`: a number of the points, and one that is kept",
    );
    says(
        rods(10, 1.0).value("row", "1", |_, _, x| x[0]).run(),
        "a column has the name `row`, which every table has",
    );
    says(rods(10, 1.0).share(0, 2).run(), "a share is computed into a file");
    let wrong = Sweep::grid("g", [Axis::values("start", "rad", [1.0])]);
    let wrong = wrong.ends(Rk4::new(-1.0), (0.0, 1.0), |[a]| trial([a, 0.1]));
    says(wrong.quiet().run(), "step");
    let one = |sweep: Sweep<1>| sweep.each([("one", "1")], |_| Ok([1.0])).quiet();
    let sign = "`a` has numbers that are not finite: ";
    says(
        one(Sweep::grid("g", [Axis::logarithmic("a", "1", -1.0, 1.0, 3)])).run(),
        sign,
    );
    says(
        one(Sweep::random("r", [Draw::logarithmic("a", "1", -1.0, 1.0)], 3, 1)).run(),
        sign,
    );
    says(
        one(Sweep::random("r", [Draw::uniform("a", "1", 0.0, f64::INFINITY)], 3, 1)).run(),
        sign,
    );
    says(rods(10, 1.0).threads(5000).run(), "at most 4096 threads");
    for draw in [
        Draw::logarithmic("a", "1", 1.0, 0.0),
        Draw::normal("a", "1", 0.0, -1.0),
        Draw::normal("a", "1", 0.0, 1e308),
    ] {
        says(one(Sweep::random("r", [draw], 3, 1)).run(), sign);
    }
    let huge = Sweep::grid("g", [Axis::linear("a", "1", 0.0, 1.0, 1 << 45)]);
    says(
        one(huge.clone()).run(),
        "there is not enough memory for 35184372088832 rows: use `run_to`",
    );
    let in_file = one(huge)
        .run_to(folder("huge").join("sweep.parquet"))
        .expect_err("too many rows");
    assert_eq!(in_file.to_string(), "a file takes 34358689792 rows at most");
    for method in [Tsit5::new().rtol(-1.0), Tsit5::new().h0(f64::NAN)] {
        let starts = || Sweep::list("rods", [("start", "rad")], vec![[1.0], [f64::NAN]]);
        let trajectories = || starts().trajectories(method, (0.0, 2.0), |[a]| trial([a, 0.1])).quiet();
        for job in [trajectories(), trajectories().in_lanes()] {
            assert!(matches!(job.run(), Err(SweepError::Invalid(_))));
        }
    }
    let none = folder("none").join("sweep.parquet");
    let nothing = rods(10, 1.0).merge(&none).expect_err("no shards").to_string();
    assert!(nothing.starts_with("0 of 1 shards are there;"), "{nothing}");
    assert!(!none.with_extension("parquet.shards").exists());
    for path in [folder("a_folder"), folder("a_folder").join("new/")] {
        let error = rods(10, 1.0).run_to(&path).expect_err("a folder").to_string();
        assert_eq!(error, format!("{} is a folder; name a file in it", path.display()));
    }
    let times = Sweep::list("rods", [("start", "rad")], vec![[1.0]]);
    let times = times.trajectories(Tsit5::new(), (0.0, 2.0), |[a]| trial([a, 0.1]));
    says(times.at([1.0, f64::NAN]).quiet().run(), "states are kept at NaN");
    let path = folder("wrong").join("sweep.parquet");
    // a corrected setting makes another sweep, but nothing was computed before
    let span = rods(10, f64::INFINITY).run_to(&path).expect_err("no end");
    assert!(span.to_string().contains("a time must be finite"), "{span}");
    assert!(path.with_extension("parquet.shards").exists());
    let mended = rods(10, 1.0).run_to(&path).expect("another sweep").complete;
    assert!(mended);
    let path = folder("many").join("sweep.parquet");
    let many = rods(1_000_000, 1.0)
        .rows_per_shard(30)
        .run_to(&path)
        .expect_err("too many shards");
    assert!(many.to_string().contains("each has 31 rows or more"), "{many}");
    for (arguments, text) in [
        (&["--shard", "4/4"][..], "I from 0 to N - 1"),
        (&["--shard"], "--shard takes a value"),
        (&["--thread"], "unknown argument --thread\nusage:"),
        (&["--merge", "--shard", "0/2"], "leave out --shard"),
    ] {
        let error = Arguments::parse(arguments.iter().map(|&text| text.to_owned())).expect_err("wrong arguments");
        assert!(error.to_string().contains(text), "{error}");
    }
}

#[test]
fn trajectories_keep_times_extrema_and_events() -> Outcome {
    mechanism! {
        pub Ball { gravity: [0, -10, 0], body ball on ground { mass: 1, joint: prismatic(y), coordinate: y } }
    }
    let table = Sweep::list("throws", [("rate", "m/s")], vec![[2.0], [4.0], [f64::NAN]])
        .trajectories(Vern7::new(), (0.0, 1.0), |[rate]| {
            Ok((Ball::new(BallParams {})?, [0.0, rate]))
        })
        .event("floor", |_| {
            Event::new(|_, x: &SVector<f64, 2>| x[0] + 1e-9).falling().terminal()
        })
        .largest("height", "m", |_, _, x| x[0])
        .least("lowest", "m", |_, _, x| x[0])
        .value("energy", "J", |ball, t, x| ball.energy(t, x))
        .at([0.25, 0.75])
        .quiet()
        .run()?;
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-7, "{a} {b}");
    // thrown up with v: returns at v/5; maximum height v^2/20 at v/10
    for (row, v) in [(0, 2.0), (1, 4.0)] {
        near(table["height"][row], v * v / 20.0);
        near(table["t of height"][row], v / 10.0);
        near(table["t"][row], v / 5.0);
        near(table["t of floor"][row], v / 5.0);
        near(table["energy"][row], v * v / 2.0);
        near(table["lowest"][row], 0.0);
        near(table["y at 0.25 s"][row], v * 0.25 - 0.3125);
    }
    assert_eq!(table["floor"][0], 1.0);
    assert!(table["y at 0.75 s"][0].is_nan() && !table["y at 0.75 s"][1].is_nan());
    assert!(
        table.failures().contains_key(&2) && table.failures().len() == 1,
        "{:?}",
        table.failures()
    );
    Ok(())
}

#[test]
fn sampled_controllers_have_gains_and_seeds_by_the_point() -> Outcome {
    mechanism! {
        pub Cart { input push: N, body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push } }
    }
    let cart = Cart::new(CartParams {})?;
    let sampled = |gain, seed| {
        let pid = Pid::new(gain, 0.0, 4.0).set_point(1.0);
        let sampled = Sampled::of_components(pid, 0.01, [Cart::S]).limits([-5.0], [5.0]);
        sampled.noise([1e-3]).seed(seed)
    };
    let axes = [
        Axis::linear("gain", "N/m", 4.0, 16.0, 4),
        Axis::linear("seed", "1", 0.0, 7.0, 8),
    ];
    let (method, span) = (Tsit5::new(), (0.0, 3.0));
    let run = |least: f64| {
        Sweep::grid("gains", axes.clone()).sampled(method, span, move |[gain, seed]| {
            if gain < least {
                return Err("no gain".into());
            }
            Ok((sampled(gain, seed as u64), cart, [0.0, 0.0]))
        })
    };
    let table = run(0.0).value("speed", "m/s", |_, _, x| x[1].abs()).quiet().run()?;
    assert_eq!((table["s"].len(), table.failures().len()), (32, 0));
    for row in 0..32 {
        let alone = sampled(table["gain"][row], table["seed"][row] as u64);
        let end = alone.end(&method, &cart, 0.0, 3.0, [0.0, 0.0])?;
        assert_eq!(
            [table["t"][row], table["s"][row], table["dot(s)"][row]],
            [3.0, end[0], end[1]]
        );
        assert_eq!(table["speed"][row], end[1].abs());
    }
    let some = run(8.0).quiet().run()?;
    assert_eq!(some.failures().len(), 8);
    assert!(
        (0..32).all(|row| some["s"][row].to_bits() == table["s"][row].to_bits() || row < 8 && some["s"][row].is_nan())
    );
    let different = |rows: [usize; 2]| table["s"][rows[0]] != table["s"][rows[1]];
    assert!(different([0, 1]) && different([0, 8]));
    Ok(())
}

#[test]
fn extrema_are_those_of_solutions() -> Outcome {
    for span in [(0.0, 3.0), (3.0, 0.0)] {
        let starts = [0.7, -1.9, 2.8, 0.0, 1.3];
        let table = Sweep::list("rods", [("start", "rad")], starts.map(|a| [a]).to_vec())
            .trajectories(Tsit5::new().rtol(1e-4), span, |[a]| trial([a, 0.1]))
            .largest("most", "rad", |_, _, x| x[0])
            .least("least", "rad/s", |_, _, x| x[3])
            .quiet()
            .run()?;
        for (row, a) in starts.into_iter().enumerate() {
            let (model, start) = trial([a, 0.1]).expect("a model");
            let solution = Tsit5::new().rtol(1e-4).solve(&model, span.0, span.1, start)?;
            let states = solution.sample((0..=30_000).map(|n| 1e-4 * f64::from(n)))?;
            let most = states.iter().fold(f64::NEG_INFINITY, |most, x| most.max(x[0]));
            let least = states.iter().fold(f64::INFINITY, |least, x| least.min(x[3]));
            let (found, t) = (table["most"][row], table["t of most"][row]);
            assert!(found > most - 1e-9, "{span:?}, {a}: {found} {most}");
            assert!((solution.at(t)?[0] - found).abs() < 1e-12, "{span:?}, {a}");
            let (found, t) = (table["least"][row], table["t of least"][row]);
            assert!(found < least + 1e-9, "{span:?}, {a}: {found} {least}");
            assert!((solution.at(t)?[3] - found).abs() < 1e-12, "{span:?}, {a}");
        }
    }
    Ok(())
}

/// Checks extrema across the reset of an event, and of a quantity that is NaN at first.
#[test]
fn extrema_know_jumps_and_what_is_not_a_number() -> Outcome {
    let start = Sweep::list("rods", [("start", "rad")], vec![[1.0]]);
    let table = start
        .trajectories(Tsit5::new(), (0.0, 2.0), |[a]| trial([a, 0.1]))
        .event("kick", |_| {
            let kick = Event::new(|t, _: &SVector<f64, 4>| t - 0.5);
            kick.reset(|_, x| x + SVector::from([0.0, 0.0, 50.0, 0.0])).terminal()
        })
        .value("rate at the end", "rad/s", |_, _, x| x[2])
        .largest("rate", "rad/s", |_, _, x| x[2])
        .least("late", "rad/s", |_, t, x| if t > 0.2 { x[2] } else { f64::NAN })
        .quiet()
        .run()?;
    assert!(table["rate"][0] > 40.0);
    assert_eq!(
        [table["rate"][0], table["t of rate"][0]],
        [table["rate at the end"][0], 0.5]
    );
    assert!(table["late"][0] < 0.0 && table["t of late"][0] > 0.2);
    Ok(())
}

/// Compares lanes with one-by-one integration, for all kinds of results and failures.
#[test]
fn trajectories_in_lanes_have_the_bits_of_those_alone() -> Outcome {
    fn same<X>(method: X, span: (f64, f64), keeps_all: bool) -> Outcome
    where
        X: ObservedEnsemble<Rods, f64, 4> + Method<Rods, f64, 4> + Clone + std::fmt::Debug + Sync,
    {
        let job = || {
            let draws = [
                Draw::uniform("start", "rad", -3.0, 3.0),
                Draw::logarithmic("gamma", "N m s", 1e-3, 1.0),
            ];
            let job = Sweep::random("rods", draws, 70, 7)
                .trajectories(method.clone(), span, |[a, gamma]| {
                    let (model, mut start) = trial([a, gamma])?;
                    if a > 2.7 {
                        start[3] = f64::NAN;
                    }
                    Ok((model, start))
                })
                .at([1.0, 0.5, 7.0])
                .event("passes", |_| Event::new(|_, x: &SVector<f64, 4>| x[0]))
                .event("over", |_| {
                    Event::new(|_, x: &SVector<f64, 4>| x[1].abs() - 2.5)
                        .rising()
                        .terminal()
                })
                .value("energy", "J", |rods, t, x| rods.energy(t, x))
                .at([-1.5, span.0, span.1])
                .quiet();
            if keeps_all {
                job.largest("height", "m", |_, _, x| -x[0].cos())
                    .least("rate", "rad/s", |_, _, x| x[2])
            } else {
                job
            }
        };
        let (alone, lanes) = (job().run()?, job().in_lanes().run()?);
        assert_eq!(alone.failures(), lanes.failures());
        assert!(
            (5..80).contains(&alone.failures().len()),
            "{:?}",
            alone.failures().len()
        );
        for column in alone.columns() {
            let bits = |table: &Table| {
                table[&column.name]
                    .iter()
                    .map(|number| number.to_bits())
                    .collect::<Vec<_>>()
            };
            assert_eq!(bits(&alone), bits(&lanes), "{}", column.name);
        }
        let ended = alone["t"].iter().filter(|&&t| t != span.1 && t != span.0).count();
        assert!(ended > 5, "terminal events: {ended}");
        Ok(())
    }
    same(Tsit5::new().max_steps(180), (0.0, 3.0), false)?;
    same(Tsit5::new(), (0.0, 3.0), true)?;
    same(Vern9::new(), (2.0, -1.0), false)?;
    same(Rodas5P::new(), (0.0, 2.0), true)?;
    same(Auto::new(), (0.0, 2.0), false)?;
    same(Rk4::new(0.01), (0.0, 2.0), false)
}

#[test]
fn exponents_are_those_of_each_alone() -> Outcome {
    let lyapunov = Lyapunov::new().tolerance(1e-6).duration(3.0);
    let axes = || {
        [
            Axis::linear("start", "rad", 0.5, 3.0, 20),
            Axis::linear("gamma", "N m s", 0.0, 1.0, 3),
        ]
    };
    let one = Sweep::grid("chaos", axes())
        .exponents::<1, _, _, _>(lyapunov, trial)
        .quiet()
        .run()?;
    let two = Sweep::grid("chaos", axes())
        .exponents::<2, _, _, _>(lyapunov, trial)
        .quiet()
        .run()?;
    let names = |table: &Table| {
        table
            .columns()
            .iter()
            .map(|column| column.name.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(names(&one), ["start", "gamma", "exponent", "uncertainty"]);
    assert_eq!(
        names(&two)[2..],
        ["exponent 1", "exponent 2", "uncertainty 1", "uncertainty 2"]
    );
    for row in 0..60 {
        let point = [one["start"][row], one["gamma"][row]];
        let Ok((rods, start)) = trial(point) else {
            assert!(one["exponent"][row].is_nan() && two["uncertainty 2"][row].is_nan());
            assert_eq!(one.failures()[&row], "too much friction");
            continue;
        };
        let alone = lyapunov.exponents::<2, _>(&rods, start)?;
        let found = ["exponent 1", "exponent 2", "uncertainty 1", "uncertainty 2"].map(|name| two[name][row]);
        assert_eq!(found, [alone.values, alone.uncertainty].concat()[..]);
        let alone = lyapunov.largest(&rods, start)?;
        assert_eq!(
            [one["exponent"][row], one["uncertainty"][row]],
            [alone.values[0], alone.uncertainty[0]]
        );
    }
    assert_eq!(one.failures().len(), 20);
    let wrong = Sweep::grid("chaos", axes())
        .exponents::<1, _, _, _>(lyapunov.duration(0.0), trial)
        .quiet()
        .run();
    assert!(wrong.expect_err("no time").to_string().starts_with("`duration` is 0.0"));
    Ok(())
}

#[test]
fn samples_are_those_of_solutions() -> Outcome {
    let times = [0.0, 0.1, 1.3, 0.7, 2.0];
    let table = Sweep::list("rods", [("start", "rad")], vec![[1.0], [2.0]])
        .trajectories(Tsit5::new(), (0.0, 2.0), |[a]| trial([a, 0.1]))
        .at(times)
        .in_lanes()
        .quiet()
        .run()?;
    for (row, a) in [1.0, 2.0].into_iter().enumerate() {
        let (model, start) = trial([a, 0.1]).expect("a model");
        let solution = Tsit5::new().solve(&model, 0.0, 2.0, start)?;
        for t in times {
            let [name, rate] = ["a", "dot(b)"].map(|name| format!("{name} at {t} s"));
            let x = solution.at(t)?;
            assert_eq!([table[&name][row], table[&rate][row]], [x[0], x[3]], "{t}");
        }
    }
    Ok(())
}

/// Reads a file with polars or pandas, whichever is installed, and prints its shape, the bits of a number, and the
/// number of failures.
const PYTHON: &str = "
import struct, sys
try:
    import polars
    table = polars.read_parquet(sys.argv[1])
    failed = len(table) - table['failure'].null_count()
except ImportError:
    import pandas
    table = pandas.read_parquet(sys.argv[1])
    failed = table['failure'].notna().sum()
print(table.shape, table['row'][249], struct.unpack('<Q', struct.pack('<d', table['a'][3]))[0], failed)
";

#[test]
fn python_reads_the_file_in_one_line() -> Outcome {
    let has = |module: &str| {
        let script = format!("import {module}");
        let python = Command::new("python3")
            .args(["-c", &script])
            .stderr(Stdio::null())
            .status();
        python.is_ok_and(|status| status.success())
    };
    let can_read = has("polars") || (has("pandas") && has("pyarrow"));
    if !can_read {
        eprintln!("skipped: python3 has neither polars nor pandas with pyarrow");
        return Ok(());
    }
    let path = folder("python").join("rods.parquet");
    rods(250, 1.0).run_to(&path)?;
    let table = Table::read(&path)?;
    let output = Command::new("python3").args(["-c", PYTHON]).arg(&path).output()?;
    let text = String::from_utf8(output.stdout)?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let expected = format!("(250, 10) 249 {} {}\n", table["a"][3].to_bits(), table.failures().len());
    assert_eq!(text, expected);
    Ok(())
}
