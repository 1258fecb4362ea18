//! FLIP: how different two pictures look to somebody who switches between them, pixel by pixel.
//!
//! P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. Fairchild, "FLIP: A Difference Evaluator
//! for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3 (2), 2020; the
//! version for pictures of a screen. Colours are compared as the eye sees them from a distance that blurs fine detail,
//! edges and points by themselves; a difference of both counts more than one of either.

use crate::Frame;
use crate::film::srgb::decode_f64;
use rayon::prelude::*;

/// Pixels in a degree of the eye's view: a 4K screen 0.7 m wide, seen from 0.7 m.
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// A colour, or another three numbers of a pixel.
type Triple = [f64; 3];

/// The mean difference of two pictures of the same size, 0 (none) to 1, seen at [`PIXELS_PER_DEGREE`].
///
/// # Panics
/// If the pictures are not of one size.
pub fn mean(reference: &Frame, test: &Frame) -> f64 {
    let differences = map(reference, test, PIXELS_PER_DEGREE);
    differences.iter().sum::<f64>() / differences.len().max(1) as f64
}

/// The difference at each pixel, 0 to 1, row by row. `pixels_per_degree` is over 0; no fewer than 1 and no more than
/// 1000 are thought of.
///
/// # Panics
/// If the pictures are not of one size.
pub fn map(reference: &Frame, test: &Frame, pixels_per_degree: f64) -> Vec<f64> {
    assert_eq!((reference.width, reference.height), (test.width, test.height), "pictures of one size");
    let density = pixels_per_degree.clamp(1.0, 1000.0);
    let [reference, test] = [reference, test].map(|frame| Seen::new(frame, density));
    let pixels = (0..reference.perceived.len()).into_par_iter().map(|at| {
        let color = color_difference(reference.perceived[at], test.perceived[at]);
        let edge = (reference.edges[at] - test.edges[at]).abs();
        let point = (reference.points[at] - test.points[at]).abs();
        // Equation 15: the stronger feature, and an exponent that makes small differences count.
        let feature = (edge.max(point) * std::f64::consts::FRAC_1_SQRT_2).sqrt();
        // Equation 16.
        libm::pow(color, 1.0 - feature.min(1.0))
    });
    pixels.collect()
}

/// A picture as the two pipelines of section 4 see it.
struct Seen {
    /// L*a*b* after the eye's blur, with Hunt's adjustment.
    perceived: Vec<Triple>,
    /// How strong an edge is at each pixel.
    edges: Vec<f64>,
    /// How strong a point or a line is.
    points: Vec<f64>,
}

impl Seen {
    fn new(frame: &Frame, density: f64) -> Seen {
        let opponent: Vec<Triple> = frame.pixels.par_iter().map(|&pixel| opponent_from_linear(linear(pixel))).collect();
        let plane = |channel: usize| opponent.iter().map(|color| color[channel]).collect::<Vec<f64>>();
        let size = (frame.width, frame.height);
        let luminance = plane(0);
        let blurred = [sensitive(&luminance, size, density, 0), sensitive(&plane(1), size, density, 1)];
        let blue = sensitive(&plane(2), size, density, 2);
        let perceived = |at: usize| {
            let color = linear_from_opponent([blurred[0][at], blurred[1][at], blue[at]]);
            hunt(lab_from_linear(color.map(|channel| channel.clamp(0.0, 1.0))))
        };
        let perceived = (0..opponent.len()).into_par_iter().map(perceived).collect();
        // Section 4.2: the achromatic channel, 0 to 1.
        let achromatic: Vec<f64> = luminance.iter().map(|y| (y + 16.0) / 116.0).collect();
        let [edges, points] = features(&achromatic, size, density);
        Seen { perceived, edges, points }
    }
}

/// The linear light of an sRGB pixel.
fn linear(pixel: u32) -> Triple {
    [16, 8, 0].map(|shift| decode_f64(f64::from(pixel >> shift & 0xff) / 255.0))
}

/// CIE XYZ from linear sRGB.
const XYZ: [Triple; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// Linear sRGB from CIE XYZ: the inverse of [`XYZ`].
const LINEAR: [Triple; 3] = [
    [3.241_003_275_5, -1.537_398_933_5, -0.498_615_831],
    [-0.969_224_292_5, 1.875_929_978_5, 0.041_554_226],
    [0.055_639_420, -0.204_011_206, 1.057_148_974],
];

fn times(matrix: &[Triple; 3], v: Triple) -> Triple {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// XYZ of white, by which the others are divided.
fn white() -> Triple {
    times(&XYZ, [1.0; 3])
}

/// Y, Cx, Cz: luminance, red against green, blue against yellow, all linear in light (section 4.1.1).
fn opponent_from_linear(color: Triple) -> Triple {
    let (xyz, white) = (times(&XYZ, color), white());
    let [x, y, z] = [0, 1, 2].map(|at| xyz[at] / white[at]);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn linear_from_opponent([luminance, red, blue]: Triple) -> Triple {
    let white = white();
    let y = (luminance + 16.0) / 116.0;
    times(&LINEAR, [(y + red / 500.0) * white[0], y * white[1], (y - blue / 200.0) * white[2]])
}

/// CIE L*a*b*.
fn lab_from_linear(color: Triple) -> Triple {
    let (xyz, white) = (times(&XYZ, color), white());
    let curve = |t: f64| {
        let bend = 6.0 / 29.0;
        if t > bend * bend * bend { libm::cbrt(t) } else { t / (3.0 * bend * bend) + 4.0 / 29.0 }
    };
    let [x, y, z] = [0, 1, 2].map(|at| curve(xyz[at] / white[at]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Colours look more colourful in bright light (section 4.1.2, after R. W. G. Hunt).
fn hunt([lightness, a, b]: Triple) -> Triple {
    [lightness, 0.01 * lightness * a, 0.01 * lightness * b]
}

/// The distance for large differences of colour (S. Abasi and others, 2020): along lightness plus across it.
fn hyab(a: Triple, b: Triple) -> f64 {
    let (da, db) = (a[1] - b[1], a[2] - b[2]);
    (a[0] - b[0]).abs() + (da * da + db * db).sqrt()
}

/// The exponent that compresses large differences of colour.
const COMPRESSED: f64 = 0.7;

/// Up to this part of the largest difference of colour, differences get [`SHARE`] of the range.
const KNEE: f64 = 0.4;

/// See [`KNEE`].
const SHARE: f64 = 0.95;

/// The difference of two colours, 0 to 1 (section 4.1.3).
fn color_difference(a: Triple, b: Triple) -> f64 {
    let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|color| hunt(lab_from_linear(color)));
    let most = libm::pow(hyab(green, blue), COMPRESSED);
    let difference = libm::pow(hyab(a, b), COMPRESSED);
    let knee = KNEE * most;
    if difference < knee {
        SHARE / knee * difference
    } else {
        (SHARE + (difference - knee) / (most - knee) * (1.0 - SHARE)).min(1.0)
    }
}

/// Table 1: contrast sensitivity of each opponent channel as two Gaussians, each by a height and a width.
const SENSITIVITY: [[(f64, f64); 2]; 3] =
    [[(1.0, 0.0047), (0.0, 1e-5)], [(1.0, 0.0053), (0.0, 1e-5)], [(34.1, 0.04), (13.5, 0.025)]];

/// The widest of them.
const WIDEST: f64 = 0.04;

/// One channel blurred by what the eye cannot resolve (equation 4): sums of Gaussians fall apart into rows and columns.
fn sensitive(plane: &[f64], size: (usize, usize), density: f64, channel: usize) -> Vec<f64> {
    use std::f64::consts::PI;
    let reach = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * density).ceil() as isize;
    let mut sum = vec![0.0; plane.len()];
    let mut total = 0.0;
    for (height, width) in SENSITIVITY[channel].into_iter().filter(|&(height, _)| height > 0.0) {
        let gauss = |at: isize| {
            let degrees = at as f64 / density;
            libm::exp(-PI * PI * degrees * degrees / width)
        };
        let kernel: Vec<f64> = (-reach..=reach).map(gauss).collect();
        let weight = height * (PI / width).sqrt();
        let whole: f64 = kernel.iter().sum();
        total += weight * whole * whole;
        let blurred = columns(&rows(plane, size, &kernel), size, &kernel);
        sum.iter_mut().zip(blurred).for_each(|(sum, value)| *sum += weight * value);
    }
    sum.iter_mut().for_each(|value| *value /= total);
    sum
}

/// How wide the eye's detectors of edges and points are, degrees.
const DETECTOR_DEGREES: f64 = 0.082;

/// The strength of edges and of points at each pixel: first and second derivatives of a Gaussian, across and down
/// (section 4.2).
fn features(plane: &[f64], size: (usize, usize), density: f64) -> [Vec<f64>; 2] {
    let deviation = 0.5 * DETECTOR_DEGREES * density;
    let reach = (3.0 * deviation).ceil() as isize;
    let gauss = |x: f64| libm::exp(-x * x / (2.0 * deviation * deviation));
    let places = || (-reach..=reach).map(|at| at as f64);
    let smooth: Vec<f64> = places().map(gauss).collect();
    let whole: f64 = smooth.iter().sum();
    let smooth: Vec<f64> = smooth.iter().map(|value| value / whole).collect();
    let first = balanced(places().map(|x| -x * gauss(x)).collect());
    let second = balanced(places().map(|x| (x * x / (deviation * deviation) - 1.0) * gauss(x)).collect());
    [first, second].map(|derivative| {
        let across = columns(&rows(plane, size, &derivative), size, &smooth);
        let down = columns(&rows(plane, size, &smooth), size, &derivative);
        across.iter().zip(down).map(|(x, y)| (x * x + y * y).sqrt()).collect()
    })
}

/// Makes the positive weights add up to 1 and the negative ones to -1.
fn balanced(mut kernel: Vec<f64>) -> Vec<f64> {
    let positive: f64 = kernel.iter().filter(|&&value| value > 0.0).sum();
    let negative: f64 = -kernel.iter().filter(|&&value| value < 0.0).sum::<f64>();
    kernel.iter_mut().for_each(|value| *value /= if *value > 0.0 { positive } else { negative });
    kernel
}

/// Beyond its edge a picture goes on as its last pixel.
fn rows(plane: &[f64], (width, height): (usize, usize), kernel: &[f64]) -> Vec<f64> {
    filtered((width, height), kernel, width, |x, y| plane[y * width + x])
}

fn columns(plane: &[f64], (width, height): (usize, usize), kernel: &[f64]) -> Vec<f64> {
    let turned = filtered((height, width), kernel, height, |y, x| plane[y * width + x]);
    (0..width * height).map(|at| turned[at % width * height + at / width]).collect()
}

fn filtered(
    (width, height): (usize, usize),
    kernel: &[f64],
    length: usize,
    value: impl Fn(usize, usize) -> f64 + Sync,
) -> Vec<f64> {
    let reach = (kernel.len() / 2) as isize;
    let at = |index: usize| {
        let (x, y) = ((index % width) as isize, index / width);
        let weighed = kernel.iter().enumerate().map(|(step, weight)| {
            let place = (x + step as isize - reach).clamp(0, length as isize - 1) as usize;
            weight * value(place, y)
        });
        weighed.sum()
    };
    (0..width * height).into_par_iter().map(at).collect()
}
