//! `caustic dump`: a recording's frames, as numbered PNG files or as y4m.

use super::parallel;
use super::print::unwritable;
use crate::cli::DumpArgs;
use crate::frame_composer::{FrameComposer, Interpolation};
use crate::hud::UiState;
use crate::screen::Size;
use crate::storage::{recordings, save_png};
use crate::{Failure, tell};
use indicatif::ProgressBar;
use physics::TICKS_PER_SECOND;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use tracer::Frame;

/// Writes the frames that the arguments ask for.
///
/// # Errors
/// If the recording cannot be played again or a frame cannot be written.
pub fn run(args: &DumpArgs) -> Result<(), Failure> {
    let mut shown = recordings::open_to_show(&args.file)?;
    let ui_state = UiState { notice: shown.missing_art.take(), ..UiState::default() };
    let replay = &mut shown.replay;
    let ticks = frame_ticks(args, replay.recording().ticks())?;
    let mut out = Out::open(args)?;
    let mut composer = FrameComposer::new(replay.simulation().table().clone(), parallel::pool(args.threads)?)?;
    composer.set_light_resolution(args.light.resolution().unwrap_or_default());
    composer.set_zoom(args.zoom);
    let (size, frames) = (out.size(args), ticks.len());
    let bar = parallel::progress_bar(ticks.len() as u64, "frames");
    // One frame is written while the next is drawn, and one waits at most.
    thread::scope(|threads| {
        let (drawn, waiting) = mpsc::sync_channel::<Frame>(1);
        let writer = threads.spawn(|| write_all(&mut out, waiting, &bar));
        for tick in ticks {
            replay.seek(tick);
            let snapshot = replay.simulation().snapshot();
            let frame = composer.draw(Interpolation::at(&snapshot), size, &ui_state)?;
            if drawn.send(frame.clone()).is_err() {
                break;
            }
        }
        drop(drawn);
        writer.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })?;
    bar.finish_and_clear();
    out.tell_older(frames);
    match replay.difference() {
        Some(difference) => Err(Failure::new(format!(
            "{} {difference}: these frames are not what was recorded; caustic verify says more",
            args.file.display()
        ))),
        None => Ok(()),
    }
}

/// Writes frames in the order in which they come, until there are no more or nobody reads on.
fn write_all(out: &mut Out, frames: Receiver<Frame>, bar: &ProgressBar) -> Result<(), Failure> {
    for (number, frame) in frames.into_iter().enumerate() {
        if !out.write(number, &frame)? {
            break;
        }
        bar.inc(1);
    }
    Ok(())
}

/// The tick of each frame: whole frames a second from the start, the last one not after the end.
fn frame_ticks(args: &DumpArgs, length: u64) -> Result<Vec<u64>, Failure> {
    let tick = |seconds: f64| (seconds * f64::from(TICKS_PER_SECOND)).round() as u64;
    let (from, to) = (args.from.map_or(0, tick), args.to.map_or(length, tick).min(length));
    if from > to {
        let length_s = length as f64 / f64::from(TICKS_PER_SECOND);
        return Err(Failure::new(format!("{} is {length_s:.3} s long; give --from less", args.file.display())));
    }
    let at = |frame: u64| from + frame * u64::from(TICKS_PER_SECOND) / u64::from(args.fps);
    Ok((0..).map(at).take_while(|tick| *tick <= to).collect())
}

/// Where frames go.
enum Out {
    Folder(PathBuf),
    Film(BufWriter<io::Stdout>),
}

impl Out {
    fn open(args: &DumpArgs) -> Result<Out, Failure> {
        if args.out == Path::new("-") {
            if io::stdout().is_terminal() {
                return Err(Failure::new(
                    "standard output is this terminal, which shows no film: send it on to a file or a program",
                ));
            }
            let mut film = BufWriter::new(io::stdout());
            let Size { width, height } = even(args.size);
            if args.size != even(args.size) {
                let Size { width: w, height: h } = args.size;
                tell(&Failure::new(format!("the sides of a y4m film are even: {w}x{h} becomes {width}x{height}")));
            }
            let header = format!("YUV4MPEG2 W{width} H{height} F{}:1 Ip A1:1 C420jpeg\n", args.fps);
            film.write_all(header.as_bytes()).map_err(|error| unwritable(&error))?;
            return Ok(Out::Film(film));
        }
        parallel::make_folder(&args.out)?;
        let before = frames_in(&args.out).len();
        if before > 0 && !args.overwrite {
            let folder = args.out.display();
            return Err(Failure::new(format!(
                "there are frames in {folder} already, {before} of them: name another folder, or write over them with \
                 --overwrite"
            )));
        }
        Ok(Out::Folder(args.out.clone()))
    }

    /// A film's sides are even: two pixels share a colour.
    fn size(&self, args: &DumpArgs) -> Size {
        match self {
            Out::Folder(_) => args.size,
            Out::Film(_) => even(args.size),
        }
    }

    /// Tells that frames of an older and longer film are still there, after the `written` ones.
    fn tell_older(&self, written: usize) {
        let Out::Folder(folder) = self else { return };
        let older = frames_in(folder).into_iter().filter(|number| *number >= written).count();
        if older > 0 {
            let folder = folder.display();
            tell(&Failure::new(format!(
                "{older} older frames are still in {folder}, after the {written} of this film"
            )));
        }
    }

    /// Writes a frame; `false` when nobody reads on.
    fn write(&mut self, number: usize, frame: &Frame) -> Result<bool, Failure> {
        match self {
            Out::Folder(folder) => save_png(frame, &folder.join(format!("{number:06}.png"))).map(|()| true),
            Out::Film(film) => match write_film_frame(film, frame) {
                Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
                result => result.map(|()| true).map_err(|error| unwritable(&error)),
            },
        }
    }
}

/// The numbers of the frames in `folder`.
fn frames_in(folder: &Path) -> Vec<usize> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let number = |name: &str| {
        let digits = name.strip_suffix(".png")?;
        let is_frame = digits.len() >= 6 && digits.bytes().all(|byte| byte.is_ascii_digit());
        digits.parse().ok().filter(|_| is_frame)
    };
    entries.filter_map(|entry| number(entry.file_name().to_str()?)).collect()
}

fn even(size: Size) -> Size {
    Size { width: size.width & !1, height: size.height & !1 }
}

/// One frame of y4m: full-range luma (ITU-R BT.601, as JFIF has it), then each colour difference at half the size.
fn write_film_frame(film: &mut impl Write, frame: &Frame) -> io::Result<()> {
    let (width, height) = (frame.width, frame.height);
    let rgb = |x: usize, y: usize| {
        let pixel = frame.pixels[y * width + x];
        [(pixel >> 16) & 255, (pixel >> 8) & 255, pixel & 255].map(|channel| channel as i32)
    };
    let luma = |[r, g, b]: [i32; 3]| ((19_595 * r + 38_470 * g + 7_471 * b + 32_768) >> 16) as u8;
    let mut planes = Vec::with_capacity(width * height * 3 / 2);
    planes.extend((0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| luma(rgb(x, y))));
    let block = |x: usize, y: usize| {
        let four = [rgb(x, y), rgb(x + 1, y), rgb(x, y + 1), rgb(x + 1, y + 1)];
        std::array::from_fn::<i32, 3, _>(|channel| four.iter().map(|pixel| pixel[channel]).sum::<i32>())
    };
    // The weights are for the sum of four pixels.
    let weights = [[-11_059, -21_709, 32_768], [32_768, -27_439, -5_329]];
    for [red, green, blue] in weights {
        let blocks = (0..height / 2).flat_map(|y| (0..width / 2).map(move |x| (2 * x, 2 * y)));
        planes.extend(blocks.map(|(x, y)| {
            let [r, g, b] = block(x, y);
            (((red * r + green * g + blue * b + (1 << 17)) >> 18) + 128).clamp(0, 255) as u8
        }));
    }
    film.write_all(b"FRAME\n")?;
    film.write_all(&planes)?;
    film.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_film_frame_of_one_grey_has_that_luma_and_no_colour() {
        let frame = Frame { width: 4, height: 2, pixels: vec![0x5a_5a5a; 8] };
        let mut bytes = Vec::new();
        write_film_frame(&mut bytes, &frame).expect("memory takes everything");
        assert_eq!(&bytes[..6], b"FRAME\n");
        assert_eq!(bytes[6..14], [0x5a; 8]);
        assert_eq!(bytes[14..], [128; 4]);
    }

    #[test]
    fn pure_colours_stand_where_bt601_puts_them() {
        let plane = |pixel: u32| {
            let mut bytes = Vec::new();
            write_film_frame(&mut bytes, &Frame { width: 2, height: 2, pixels: vec![pixel; 4] }).expect("memory");
            (bytes[6], bytes[10], bytes[11])
        };
        assert_eq!(plane(0xff_0000), (76, 85, 255));
        assert_eq!(plane(0x00_ff00), (150, 44, 21));
        assert_eq!(plane(0x00_00ff), (29, 255, 107));
        assert_eq!(plane(0xff_ffff), (255, 128, 128));
    }
}
