//! Transforms: an element's coordinates to the table's, through its own transforms and its ancestors', as one
//! similarity.
//!
//! Only moves, turns, mirrors and uniform scales are allowed, because a circle must stay a circle and a line's
//! thickness must stay one number.

use geometry::{DVec2, trig};
use glam::DAffine2;
use svgtypes::{TransformListParser, TransformListToken};

/// Table millimetres from an element's own coordinates.
#[derive(Clone, Copy, Debug)]
pub(in crate::table) struct Transform {
    table_from_own: DAffine2,
}

impl Transform {
    /// Coordinates of which one is this many millimetres.
    pub fn scaling(mm_per_unit: f64) -> Transform {
        Transform { table_from_own: DAffine2::from_scale(DVec2::splat(mm_per_unit)) }
    }

    /// The place inside this one that a `transform` attribute says, or what is wrong with it.
    pub fn transformed(&self, attribute: &str) -> Result<Transform, String> {
        let mut table_from_own = self.table_from_own;
        for token in TransformListParser::from(attribute) {
            let token = token.map_err(|_| {
                let usual = "translate(x y), rotate(degrees), scale(factor) or matrix(a b c d e f)";
                format!("the transform `{attribute}` cannot be read; write {usual}")
            })?;
            table_from_own *= affine(token);
        }
        if table_from_own.is_finite() {
            Ok(Transform { table_from_own })
        } else {
            Err(format!("the transform `{attribute}` gives numbers that are too large"))
        }
    }

    /// The uniform scale factor, or why there is none.
    pub fn scale(&self) -> Result<f64, String> {
        let (x, y) = (self.table_from_own.matrix2.x_axis, self.table_from_own.matrix2.y_axis);
        let (x_squared, y_squared) = (x.length_squared(), y.length_squared());
        let largest = x_squared.max(y_squared);
        if largest < 1e-12 {
            return Err("its transforms shrink it to nothing".to_string());
        }
        if !largest.is_finite() {
            return Err("its transforms make it larger than any number".to_string());
        }
        let slack = 1e-6 * largest;
        if (x_squared - y_squared).abs() > slack || x.dot(y).abs() > slack {
            return Err(
                "its transforms stretch or skew it; a thing may only be moved, turned and uniformly scaled".to_string()
            );
        }
        Ok(self.table_from_own.matrix2.determinant().abs().sqrt())
    }

    /// Nothing of what is in it has an area.
    pub fn is_flat(&self) -> bool {
        self.table_from_own.matrix2.determinant() == 0.0
    }

    /// Left and right are swapped.
    pub fn mirrors(&self) -> bool {
        self.table_from_own.matrix2.determinant() < 0.0
    }

    /// A way in millimetres, as a way in the element's own coordinates.
    pub fn own_vector(&self, way_mm: DVec2) -> DVec2 {
        self.table_from_own.matrix2.inverse() * way_mm
    }

    /// A point, mm.
    pub fn point(&self, x: f64, y: f64) -> DVec2 {
        self.table_from_own.transform_point2(DVec2::new(x, y))
    }
}

fn affine(token: TransformListToken) -> DAffine2 {
    let columns = |a, b, c, d, e, f| DAffine2::from_cols(DVec2::new(a, b), DVec2::new(c, d), DVec2::new(e, f));
    match token {
        TransformListToken::Matrix { a, b, c, d, e, f } => columns(a, b, c, d, e, f),
        TransformListToken::Translate { tx, ty } => columns(1.0, 0.0, 0.0, 1.0, tx, ty),
        TransformListToken::Scale { sx, sy } => columns(sx, 0.0, 0.0, sy, 0.0, 0.0),
        TransformListToken::Rotate { angle } => {
            let (sin, cos) = trig::sin_cos(angle.to_radians());
            columns(cos, sin, -sin, cos, 0.0, 0.0)
        }
        TransformListToken::SkewX { angle } => columns(1.0, 0.0, libm::tan(angle.to_radians()), 1.0, 0.0, 0.0),
        TransformListToken::SkewY { angle } => columns(1.0, libm::tan(angle.to_radians()), 0.0, 1.0, 0.0, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transforms_apply_from_the_right() {
        let transform = Transform::scaling(1.0).transformed("translate(100 0) rotate(90) scale(2)").unwrap();
        assert!(transform.point(10.0, 0.0).distance(DVec2::new(100.0, 20.0)) < 1e-12);
        assert!((transform.scale().unwrap() - 2.0).abs() < 1e-12);
        assert!(!transform.mirrors());
    }

    #[test]
    fn a_turn_may_have_its_own_middle() {
        let transform = Transform::scaling(1.0).transformed("rotate(180 50 60)").unwrap();
        assert!(transform.point(40.0, 60.0).distance(DVec2::new(60.0, 60.0)) < 1e-12);
    }

    #[test]
    fn a_mirror_is_a_similarity_and_a_stretch_is_not() {
        let mirror = Transform::scaling(1.0).transformed("matrix(-1 0 0 1 514 0)").unwrap();
        assert!(mirror.mirrors() && mirror.scale() == Ok(1.0));
        for stretch in ["scale(2 1)", "skewX(10)", "matrix(1 0 0.2 1 0 0)", "scale(0)"] {
            assert!(Transform::scaling(1.0).transformed(stretch).unwrap().scale().is_err(), "{stretch}");
        }
    }
}
