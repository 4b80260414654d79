//! Several processes and threads want the computer algebra system at once.

use std::process::{Command, Stdio};

use hardpoint_codegen::session;

/// Symbolica aborts a process that would be its second one for a user; the lock makes it wait.
#[test]
fn processes_wait_for_each_other_and_print_the_same() {
    let start = || {
        Command::new(env!("CARGO_BIN_EXE_hardpoint-codegen"))
            .arg("list")
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts")
    };
    let running: Vec<_> = (0..3).map(|_| start()).collect();
    let outputs: Vec<_> = running
        .into_iter()
        .map(|process| process.wait_with_output().expect("the program ends"))
        .collect();
    for output in &outputs {
        assert!(output.status.success(), "{output:?}");
        assert_eq!(output.stdout, outputs[0].stdout);
    }
    let text = String::from_utf8_lossy(&outputs[0].stdout);
    assert!(text.contains("euler_parameters"), "{text}");
}

#[test]
fn threads_wait_for_each_other() {
    let threads: Vec<_> =
        (0..4).map(|k| std::thread::spawn(move || session::run(move || k * k))).collect();
    for (k, thread) in threads.into_iter().enumerate() {
        assert_eq!(thread.join().expect("no panic").expect("a session"), k * k);
    }
}

#[test]
#[should_panic(expected = "the job failed")]
fn a_panic_of_the_job_reaches_the_caller_and_frees_the_lock() {
    let failed = std::panic::catch_unwind(|| session::run(|| panic!("the job failed")));
    assert_eq!(session::run(|| 1).expect("the lock is free again"), 1);
    if let Err(panic) = failed {
        std::panic::resume_unwind(panic);
    }
}
