//! Pages that the memory of large scenes comes in.

/// Bytes of a large page, of x86-64 and of most other processors.
#[cfg(target_os = "linux")]
const LARGE_PAGE: usize = 2 << 20;

/// The same storage, which nothing was written to, in large pages where the system gives them to those who ask. A processor reads ahead within a page: where a
/// sweep goes through a hundred megabytes, small ones make it wait.
pub(crate) fn in_large_pages<T>(storage: Vec<T>) -> Vec<T> {
    #[cfg(target_os = "linux")]
    {
        let first = storage.as_ptr().map_addr(|at| at.next_multiple_of(LARGE_PAGE));
        let end = (storage.as_ptr().addr() + storage.capacity() * size_of::<T>()) / LARGE_PAGE * LARGE_PAGE;
        if first.addr() < end {
            // SAFETY: these pages lie within the storage, and the advice changes nothing that is stored. Where it cannot be followed all stays as it is
            unsafe { libc::madvise(first.cast_mut().cast(), end - first.addr(), libc::MADV_HUGEPAGE) };
        }
    }
    storage
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use std::fs::read_to_string;

    /// Whether the mapping that holds this address is one of those that large pages were asked for; none where the system does not tell.
    fn is_advised(address: usize) -> Option<bool> {
        let maps = read_to_string("/proc/self/smaps").ok()?;
        let mut is_it = false;
        for line in maps.lines() {
            let ends = line.split(' ').next().and_then(|ends| ends.split_once('-'));
            let ends =
                ends.and_then(|(a, b)| Some((usize::from_str_radix(a, 16).ok()?, usize::from_str_radix(b, 16).ok()?)));
            if let Some((start, end)) = ends {
                is_it = (start..end).contains(&address);
            } else if let Some(flags) = line.strip_prefix("VmFlags:").filter(|_| is_it) {
                return Some(flags.split(' ').any(|flag| flag == "hg"));
            }
        }
        None
    }

    /// Where the kernel has large pages, those in the middle of large storage are asked for, and small storage is left alone.
    #[test]
    fn invariant_large_storage_comes_in_large_pages() {
        let large = in_large_pages(vec![0_u64; LARGE_PAGE / 2]);
        let small = in_large_pages(vec![1_u64; 1000]);
        assert!(large.iter().all(|x| *x == 0) && small.iter().all(|x| *x == 1));
        assert!(in_large_pages(Vec::<[u8; 0]>::new()).is_empty());
        let middle = large.as_ptr().addr() + 2 * LARGE_PAGE;
        if std::path::Path::new("/sys/kernel/mm/transparent_hugepage/enabled").exists() {
            assert_ne!(is_advised(middle), Some(false));
        }
    }
}
