//! Which of the machine's adapters draws.
//!
//! In: an [`AdapterChoice`]. Out: an adapter, or which there are instead.

use std::path::Path;

use super::error::GpuError;

/// Which of the machine's adapters to take.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub enum AdapterChoice {
    /// The fastest, or what `WGPU_ADAPTER_NAME` names.
    #[default]
    Fastest,
    /// One that runs on the processor: the same pictures on every machine.
    Software,
    /// The first whose name contains this, in any case.
    Named(String),
}

/// Keeps Mesa's choice among several GPUs, a layer of Vulkan, from asking a Wayland that cannot be there: it
/// would print an error of its own. Who has set one of the layer's variables wants it.
///
/// # Safety
/// No other thread runs yet, as [`std::env::set_var`] demands.
pub unsafe fn ask_no_absent_display() {
    let has_wayland =
        std::env::var_os("XDG_RUNTIME_DIR").is_some_and(|folder| Path::new(&folder).is_absolute());
    let is_wanted = ["NODEVICE_SELECT", "DRI_PRIME", "MESA_VK_DEVICE_SELECT"];
    if !has_wayland && is_wanted.iter().all(|name| std::env::var_os(name).is_none()) {
        // SAFETY: the caller's promise.
        unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    }
}

pub(super) async fn find_adapter(
    instance: &wgpu::Instance,
    choice: &AdapterChoice,
    surface: Option<&wgpu::Surface<'_>>,
) -> Result<wgpu::Adapter, GpuError> {
    let named = match choice {
        AdapterChoice::Named(name) => Some(name.clone()),
        AdapterChoice::Fastest => std::env::var("WGPU_ADAPTER_NAME").ok(),
        AdapterChoice::Software => None,
    };
    if let Some(name) = named {
        let shows = |a: &wgpu::Adapter| surface.is_none_or(|s| a.is_surface_supported(s));
        let all = instance.enumerate_adapters(wgpu::Backends::all()).await.into_iter().filter(shows);
        let (mut fit, others): (Vec<_>, Vec<_>) =
            all.partition(|a| a.get_info().name.to_lowercase().contains(&name.to_lowercase()));
        if fit.is_empty() {
            return Err(GpuError::NoAdapter(none_called(&name, &others)));
        }
        return Ok(fit.swap_remove(0));
    }
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        force_fallback_adapter: *choice == AdapterChoice::Software,
        compatible_surface: surface,
        ..Default::default()
    };
    let found = instance.request_adapter(&options).await;
    found.map_err(|_| {
        GpuError::NoAdapter(match choice {
            AdapterChoice::Software => format!("no software driver was found\n{}", advice()),
            _ => format!("no GPU and no software driver was found\n{}", advice()),
        })
    })
}

/// That no adapter has `name` in its own, and which there are.
fn none_called(name: &str, others: &[wgpu::Adapter]) -> String {
    let mut known: Vec<String> =
        others.iter().map(|adapter| format!("  {}", adapter.get_info().name)).collect();
    known.dedup();
    match known.is_empty() {
        true => format!("no GPU and no software driver was found\n{}", advice()),
        false => format!("no GPU has `{name}` in its name; the GPUs are\n{}", known.join("\n")),
    }
}

fn advice() -> &'static str {
    if cfg!(target_os = "linux") {
        "install a Vulkan driver; Mesa's software driver runs everywhere:\n  \
         Debian, Ubuntu  apt install mesa-vulkan-drivers\n  \
         Fedora          dnf install mesa-vulkan-drivers vulkan-loader\n  \
         Arch            pacman -S vulkan-swrast vulkan-icd-loader"
    } else {
        "update the driver of the graphics card"
    }
}
