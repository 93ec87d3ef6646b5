//! One Python interpreter on one thread, on which every call to the oracles runs.
//!
//! The only file with `unsafe` code: which Python starts is decided by its configuration, never by PATH or by the
//! environment, and that configuration has no safe interface.
#![allow(unsafe_code)]

use std::ffi::CStr;
use std::mem::MaybeUninit;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, OnceLock};
use std::thread;

use contact_vv::checkout::root;
use contact_vv::error::Error;
use contact_vv::oracle::cross_code::independent::Folder;
use contact_vv::oracle::cross_code::{SET_UP, revolution, scripts};
use pyo3::exceptions::PyModuleNotFoundError;
use pyo3::prelude::*;
use pyo3::{ffi, types::PyTracebackMethods};

/// The interpreter the oracles were installed for.
const INTERPRETER: &CStr = c"/usr/bin/python3";
/// Ignored folder for what the set-up installs and the form compiler leaves.
pub const INSTALLED: &str = "oracles/.python";

/// The remedy where Python runs and a script complains.
const SCRIPTS: &str = "see the traceback: the scene or a file under oracles is at fault";

/// What Python said, and the remedy.
type Told = (String, &'static str);

type Job = Box<dyn FnOnce() + Send>;

/// Runs `work` with Python on the oracle thread and waits for what it returns.
pub fn with_python<T: Send + 'static>(
    work: impl FnOnce(Python<'_>) -> PyResult<T> + Send + 'static,
) -> Result<T, Error> {
    static THREAD: OnceLock<Mutex<Sender<Job>>> = OnceLock::new();
    static READY: OnceLock<Result<(), Told>> = OnceLock::new();
    let thread = THREAD.get_or_init(|| {
        let (sender, jobs) = channel();
        thread::spawn(|| serve(jobs));
        Mutex::new(sender)
    });
    let (answer, answered) = channel();
    let job: Job = Box::new(move || {
        let ready =
            READY.get_or_init(|| boot().and_then(|()| Python::attach(|py| prepare(py).map_err(|e| told(py, &e)))));
        let result = ready.clone().and_then(|()| Python::attach(|py| work(py).map_err(|error| told(py, &error))));
        // The asker waits; were it gone, nobody would miss the answer.
        let _ = answer.send(result);
    });
    let stopped = || Error::at("python oracles", "the oracle thread has stopped", SCRIPTS);
    let sent = thread.lock().map_err(|_| stopped()).map(|sender| sender.send(job));
    sent?.map_err(|_| stopped())?;
    let result = answered.recv().map_err(|_| stopped())?;
    result.map_err(|(said, remedy)| Error::at("python oracles", said, remedy))
}

fn serve(jobs: Receiver<Job>) {
    jobs.into_iter().for_each(|job| job());
}

/// Starts Python from a configuration that names the interpreter and ignores the environment.
fn boot() -> Result<(), Told> {
    // SAFETY: called once, on the oracle thread, before any other use of Python. `PyConfig_InitIsolatedConfig`
    // initialises the whole structure, which is cleared again; the thread state is released so that `Python::attach`
    // can take it.
    unsafe {
        let mut config = MaybeUninit::<ffi::PyConfig>::uninit();
        ffi::PyConfig_InitIsolatedConfig(config.as_mut_ptr());
        let mut config = config.assume_init();
        // Nothing is written beside the scripts.
        config.write_bytecode = 0;
        let name = &raw mut config.program_name;
        let mut status = ffi::PyConfig_SetBytesString(&raw mut config, name, INTERPRETER.as_ptr());
        if ffi::PyStatus_Exception(status) == 0 {
            status = ffi::Py_InitializeFromConfig(&raw const config);
        }
        ffi::PyConfig_Clear(&raw mut config);
        if ffi::PyStatus_Exception(status) != 0 {
            return Err((format!("{} does not start", INTERPRETER.to_string_lossy()), SET_UP));
        }
        ffi::PyEval_SaveThread();
    }
    Ok(())
}

/// Environment and paths, then every module the oracles import.
fn prepare(py: Python<'_>) -> PyResult<()> {
    let path = py.import("sys")?.getattr("path")?;
    let own = Folder::ALL.into_iter().filter(|folder| folder.is_set_up());
    for folder in [scripts(), revolution::folder()].into_iter().chain(own.map(Folder::path)) {
        path.call_method1("insert", (0, folder.display().to_string()))?;
    }
    py.import("environment")?.call_method1("prepare", (root().join(INSTALLED).display().to_string(),))?;
    Ok(())
}

/// What Python said, with its traceback; a missing module by its name.
fn told(py: Python<'_>, error: &PyErr) -> Told {
    if error.is_instance_of::<PyModuleNotFoundError>(py) {
        let name: String = error.value(py).getattr("name").and_then(|name| name.extract()).unwrap_or_default();
        return (format!("module `{name}` is missing in {}", INTERPRETER.to_string_lossy()), SET_UP);
    }
    let traceback = error.traceback(py).and_then(|traceback| traceback.format().ok()).unwrap_or_default();
    (format!("{traceback}{error}"), SCRIPTS)
}
