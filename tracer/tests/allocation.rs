//! A renderer that is warm asks for no memory: a frame has no time for that.

use geometry::DVec2;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use tracer::{DisplayBuffer, Integrator, Renderer, Scene, View, scenes};

static ASKED: AtomicUsize = AtomicUsize::new(0);

struct Counting;

// SAFETY: everything is left to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ASKED.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promises are the system's.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ASKED.fetch_add(1, Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// All lamps flash, two balls roll to and fro and one floats: when every thread has been everywhere, everything is there.
/// Which thread goes where is chance, so some rounds are given to become warm; then two in a row must ask for nothing.
fn asks_for_nothing_once_warm(integrator: Integrator) {
    let view = View::fit(270, 540, scenes::SIZE_MM);
    let (props, half) = (scenes::props(&view), scenes::props(&view.halved()).floor);
    let mut renderer = Renderer::with(integrator);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
    pool.install(|| {
        let mut scene = Scene { half_floor: Some(&half), ..scenes::table(view, &props) };
        scenes::lift(&mut scene, &[12.0]);
        let mut display = DisplayBuffer::default();
        let mut round = || {
            let before = ASKED.load(Ordering::Relaxed);
            for frame in 0..24 {
                let to = if frame < 12 { 1.0 } else { -1.0 };
                scenes::roll(&mut scene, DVec2::new(3.0 * to, -5.0 * to));
                for (at, lamp) in scene.lamps.iter_mut().enumerate() {
                    lamp.color[0] = 0.2 + ((at + frame) % 5) as f32 * 0.1;
                }
                renderer.draw(&scene, 1.0, &mut display);
            }
            ASKED.load(Ordering::Relaxed) - before
        };
        let asked: Vec<usize> = (0..24).map(|_| round()).collect();
        assert!(asked[0] > 1000, "a cold renderer asks for memory: {asked:?}");
        assert!(asked.windows(2).any(|two| two == [0, 0]), "{asked:?}");
    });
}

/// One test, since what other tests ask for would be counted too.
#[test]
fn a_warm_renderer_allocates_nothing() {
    asks_for_nothing_once_warm(Integrator::Exact);
    asks_for_nothing_once_warm(Integrator::HalfResolution);
}
