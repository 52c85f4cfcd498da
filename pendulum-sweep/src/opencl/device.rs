//! OpenCL devices and kernels.

use std::fmt;
use std::ptr;
use std::sync::Mutex;

use opencl3::command_queue::CommandQueue;
use opencl3::context::Context;
use opencl3::device::{self, CL_DEVICE_TYPE_ALL, CL_DEVICE_TYPE_GPU};
use opencl3::error_codes::ClError;
use opencl3::kernel::ExecuteKernel;
use opencl3::memory::{Buffer, CL_MEM_READ_ONLY, CL_MEM_WRITE_ONLY};
use opencl3::platform::get_platforms;
use opencl3::program::Program;
use opencl3::types::{CL_BLOCKING, cl_int};
use pendulum_core::real::Float;

use super::source::Settings;
use crate::error::SweepError;

/// Serializes device discovery and compilation, as not all drivers are thread-safe there.
static DRIVERS: Mutex<()> = Mutex::new(());

/// A device that runs OpenCL.
pub struct Device {
    device: device::Device,
    name: String,
}

impl Device {
    /// Returns all devices of this machine, GPUs first; none without OpenCL.
    ///
    /// # Errors
    /// [`SweepError::Device`].
    pub fn all() -> Result<Vec<Self>, SweepError> {
        let _one_at_a_time = DRIVERS.lock();
        let mut devices = Vec::new();
        // a missing library or driver means no devices
        for platform in get_platforms().unwrap_or_default() {
            for id in platform.get_devices(CL_DEVICE_TYPE_ALL).unwrap_or_default() {
                let device = device::Device::new(id);
                let name = device.name().map_err(failed("ask a device for its name"))?;
                devices.push(Self { device, name });
            }
        }
        devices.sort_by_key(|device| !device.is_gpu());
        Ok(devices)
    }

    /// Returns the first device of [`all`](Self::all).
    ///
    /// # Errors
    /// [`SweepError::Device`], also if there is none.
    pub fn first() -> Result<Self, SweepError> {
        let none = "there is no OpenCL device: install the driver of the GPU, or `pocl`, which runs on the CPU";
        Self::all()?
            .into_iter()
            .next()
            .ok_or_else(|| SweepError::Device(none.to_owned()))
    }

    /// Name of the device.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// True if the device is a GPU.
    #[must_use]
    pub fn is_gpu(&self) -> bool {
        self.device.dev_type().is_ok_and(|kind| kind & CL_DEVICE_TYPE_GPU != 0)
    }
}

impl fmt::Debug for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Device").field(&self.name).finish()
    }
}

fn failed(what: &str) -> impl FnOnce(ClError) -> SweepError {
    move |error| SweepError::Device(format!("OpenCL could not {what}: {error}"))
}

/// Kernel `integrate` of a program on a device.
pub(super) struct Kernel {
    device: String,
    context: Context,
    queue: CommandQueue,
    program: Program,
}

/// Final states of trajectories, one row each.
pub(super) struct Ends<T> {
    /// The state, the time, and two details of the code.
    pub(super) numbers: Vec<T>,
    pub(super) codes: Vec<cl_int>,
}

impl Kernel {
    pub(super) fn new(device: &Device, source: &str, single: bool) -> Result<Self, SweepError> {
        let name = device.name.clone();
        if !single && device.device.double_fp_config().unwrap_or(0) == 0 {
            return Err(SweepError::Device(format!(
                "{name} has no double precision: take `method_in_single`"
            )));
        }
        let options = if single {
            "-DPENDULUM_SINGLE -cl-single-precision-constant"
        } else {
            ""
        };
        let _one_at_a_time = DRIVERS.lock();
        let context = Context::from_device(&device.device).map_err(failed("use the device"))?;
        let queue = CommandQueue::create_default(&context, 0).map_err(failed("make a queue"))?;
        let program = Program::create_and_build_from_source(&context, source, options)
            .map_err(|log| SweepError::Device(format!("the compiler of {name} refuses the kernel: {log}")))?;
        Ok(Self {
            device: name,
            context,
            queue,
            program,
        })
    }

    pub(super) fn device_name(&self) -> &str {
        &self.device
    }

    /// Integrates from `starts` (the initial states and first step sizes) with `parameters`; both hold a row for each
    /// trajectory.
    pub(super) fn integrate<T: Float>(
        &self,
        (count, length): (usize, usize),
        (t0, t1): (T, T),
        settings: &Settings<T>,
        parameters: &[T],
        starts: &[T],
    ) -> Result<Ends<T>, ClError> {
        let mut ends = Ends {
            numbers: vec![T::default(); count * (length + 3)],
            codes: vec![0; count],
        };
        let (parameters, starts) = (transposed(parameters, count), transposed(starts, count));
        // SAFETY: all buffers have the lengths that the kernel reads and writes, its arguments have the declared order
        // and types, and reading waits until the kernel has ended.
        #[expect(unsafe_code, reason = "OpenCL does not check kernels")]
        unsafe {
            let kernel = opencl3::kernel::Kernel::create(&self.program, "integrate")?;
            let to_device = |numbers: &[T]| {
                let mut buffer =
                    Buffer::<T>::create(&self.context, CL_MEM_READ_ONLY, numbers.len().max(1), ptr::null_mut())?;
                if !numbers.is_empty() {
                    self.queue
                        .enqueue_write_buffer(&mut buffer, CL_BLOCKING, 0, numbers, &[])?;
                }
                Ok::<_, ClError>(buffer)
            };
            let (parameters, starts) = (to_device(&parameters)?, to_device(&starts)?);
            let numbers = Buffer::<T>::create(&self.context, CL_MEM_WRITE_ONLY, ends.numbers.len(), ptr::null_mut())?;
            let codes = Buffer::<cl_int>::create(&self.context, CL_MEM_WRITE_ONLY, count, ptr::null_mut())?;
            let done = ExecuteKernel::new(&kernel)
                .set_arg(&(count as u32))
                .set_arg(&t0)
                .set_arg(&t1)
                .set_arg(&settings.h)
                .set_arg(&settings.rtol)
                .set_arg(&settings.atol)
                .set_arg(&settings.h_min)
                .set_arg(&settings.h_max)
                .set_arg(&settings.max_steps)
                .set_arg(&parameters)
                .set_arg(&starts)
                .set_arg(&numbers)
                .set_arg(&codes)
                .set_global_work_size(count)
                .enqueue_nd_range(&self.queue)?;
            let done = [done.get()];
            self.queue
                .enqueue_read_buffer(&numbers, CL_BLOCKING, 0, &mut ends.numbers, &done)?;
            self.queue
                .enqueue_read_buffer(&codes, CL_BLOCKING, 0, &mut ends.codes, &done)?;
        }
        ends.numbers = transposed(&ends.numbers, length + 3);
        Ok(ends)
    }
}

/// Transposes to column-major order, so that neighbours on the device read neighbours in memory.
fn transposed<T: Copy>(numbers: &[T], rows: usize) -> Vec<T> {
    let width = numbers.len() / rows.max(1);
    let column = |c: usize| (0..rows).map(move |row| numbers[row * width + c]);
    (0..width).flat_map(column).collect()
}
