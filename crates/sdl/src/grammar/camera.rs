//! `camera { ... }`: the frame in the sequence of section 1.1 of the light spec.
use std::sync::Arc;

use raggio_math::{Affine, EPS, Vec3};
use raggio_scene::{
    Camera, CameraKind, Color, FocalBlur, MeshCamera, Normal, ObjectKind, Pigment, Placed, Shape,
};

use super::util::{comma_float, float, optional_second, set, set_flag, set_vec3, take, vec3, word};
use super::{normal, object, pigment};
use crate::keyword::Kw;
use crate::parser::{Parser, Result, Tok};
use crate::value::Kind;

/// A camera that is not complete yet. What has been said is pending until it acts.
struct Draft {
    camera: Camera,
    sky: Vec3,
    angle: Option<(f64, Option<f64>)>,
    look_at: Option<Vec3>,
    aim: Vec3,
    focal_point: Option<Vec3>,
    blur: FocalBlur,
    transform: Affine,
    wrote_frame: bool,
    wrote_angle: bool,
    copied: bool,
    /// Before version 3.5 every word acts at once.
    in_order: bool,
    smooth: bool,
}

/// The camera that the language begins with.
fn plain() -> Camera {
    Camera {
        kind: CameraKind::Perspective,
        location: Vec3::ZERO,
        direction: Vec3::Z,
        up: Vec3::Y,
        right: Vec3::X * 1.33,
        angle: 90.0,
        focal_blur: None,
        normal: None,
    }
}

impl Draft {
    fn new(camera: Camera) -> Self {
        let blur = camera.focal_blur.clone().unwrap_or(FocalBlur {
            aperture: 0.0,
            min_samples: 0,
            max_samples: 0,
            confidence: 0.9,
            variance: 1e-4,
            focal_distance: -1.0,
            bokeh: None,
        });
        Draft {
            camera,
            sky: Vec3::Y,
            angle: None,
            look_at: None,
            aim: Vec3::Z,
            focal_point: None,
            blur,
            transform: Affine::IDENTITY,
            wrote_frame: false,
            wrote_angle: false,
            copied: false,
            in_order: false,
            smooth: false,
        }
    }

    /// Lets act what is pending: the angle, where to look, the transforms.
    fn act(&mut self, p: &mut Parser) -> Result<()> {
        if let Some((angle, vertical)) = self.angle.take() {
            self.set_angle(p, angle, vertical)?;
        }
        if let Some(at) = self.look_at.take() {
            self.aim = at;
            self.turn_to(p, at)?;
        }
        let t = std::mem::replace(&mut self.transform, Affine::IDENTITY);
        if let Some(point) = self.focal_point.take() {
            self.blur.focal_distance = (point - self.camera.location).length();
        }
        if !self.in_order {
            self.scale_orthographic();
        }
        transform(&mut self.camera, &t);
        Ok(())
    }

    fn set_angle(&mut self, p: &mut Parser, angle: f64, vertical: Option<f64>) -> Result<()> {
        let camera = &mut self.camera;
        camera.angle = angle;
        match &mut camera.kind {
            CameraKind::Perspective | CameraKind::Orthographic => {
                if angle >= 180.0 {
                    let span = p.span();
                    return p.error(
                        "bad-angle",
                        "the angle of this camera must be less than 180 degrees",
                        span,
                    );
                }
                if angle != 0.0 {
                    let length = camera.right.length() / (2.0 * (angle.to_radians() / 2.0).tan());
                    camera.direction = camera.direction.normalize_or_zero() * length;
                }
            }
            CameraKind::Spherical { v_angle } => *v_angle = vertical.unwrap_or(angle / 2.0),
            _ => {}
        }
        Ok(())
    }

    /// Turns the frame towards a point; the lengths of its vectors and its handedness stay.
    fn turn_to(&mut self, p: &mut Parser, at: Vec3) -> Result<()> {
        let camera = &mut self.camera;
        let span = p.span();
        let towards = at - camera.location;
        if towards.length_squared() < EPS {
            return p.error(
                "bad-look-at",
                "the camera's location and look_at point must not be the same",
                span,
            );
        }
        let lengths = (camera.direction.length(), camera.up.length(), camera.right.length());
        let left_handed = camera.up.cross(camera.direction).dot(camera.right) > 0.0;
        let d = towards.normalize();
        let mut r = self.sky.cross(d);
        if r.abs().max_element() < EPS {
            p.warn(
                "parallel-look-at",
                "look_at lies along the sky vector; the old right vector is kept",
                span,
            );
            r = camera.right;
        }
        let r = r.normalize_or_zero();
        camera.direction = d * lengths.0;
        camera.up = d.cross(r) * lengths.1;
        camera.right = r * if left_handed { lengths.2 } else { -lengths.2 };
        Ok(())
    }

    /// An orthographic view without a frame of its own shows what a perspective one would at the point looked at.
    fn scale_orthographic(&mut self) {
        let camera = &self.camera;
        let wanted = self.wrote_angle || !self.wrote_frame;
        if !self.copied && wanted && matches!(camera.kind, CameraKind::Orthographic) {
            self.fit_orthographic();
        }
    }

    /// Makes the frame as large as a perspective view is at the point looked at.
    fn fit_orthographic(&mut self) {
        let camera = &mut self.camera;
        let k = (self.aim - camera.location).length() / camera.direction.length();
        if camera.right.length() > EPS && camera.up.length() > EPS && k.is_finite() {
            camera.right *= k;
            camera.up *= k;
        }
    }

    fn finish(mut self, p: &mut Parser) -> Result<Camera> {
        self.act(p)?;
        let (smooth, blur) = (self.smooth, self.blur);
        let mut camera = self.camera;
        if let CameraKind::Mesh(mesh) = &mut camera.kind {
            Arc::make_mut(mesh).smooth |= smooth;
        }
        let used = blur.aperture != 0.0 && blur.max_samples > 0;
        camera.focal_blur = used.then_some(blur);
        Ok(camera)
    }
}

/// Moves a camera's frame.
pub fn transform(camera: &mut Camera, t: &Affine) {
    camera.location = t.transform_point3(camera.location);
    for vector in [&mut camera.direction, &mut camera.up, &mut camera.right] {
        *vector = t.transform_vector3(*vector);
    }
}

/// `{ ... }` of a camera; the word has been read. Below version 3.5 words act in the order written
/// (`orthographic` sizes the frame as it is then), and a second camera goes on where the first has ended.
pub fn block(p: &mut Parser) -> Result<Camera> {
    let in_order = p.settings.version.language < 350;
    let before = if in_order { p.scene.camera.clone() } else { None };
    let base = before.unwrap_or_else(|| p.defaults.camera.as_deref().cloned().unwrap_or_else(plain));
    let mut draft = Draft { in_order, ..Draft::new(base) };
    p.block("camera", |p| {
        let known = item(p, &mut draft)?;
        if in_order {
            draft.act(p)?;
        }
        Ok(known)
    })?;
    draft.finish(p)
}

fn item(p: &mut Parser, draft: &mut Draft) -> Result<bool> {
    if let Some(t) = p.accept_transform()? {
        draft.transform = t * draft.transform;
        return Ok(true);
    }
    if p.peek()? == Tok::Value(Kind::Camera) {
        let copy = Draft::new((*take!(p, Camera)).clone());
        *draft = Draft { copied: true, in_order: draft.in_order, ..copy };
        return Ok(true);
    }
    let Some(key) = word(p)? else { return p.accept_punct(',') };
    if let Some(kind) = kind(key) {
        p.next()?;
        draft.camera.kind = match kind {
            CameraKind::Cylinder(_) => CameraKind::Cylinder(p.int("type of cylinder camera", 1..=4)? as u8),
            CameraKind::Spherical { .. } => {
                draft.camera.angle = 360.0;
                kind
            }
            kind => kind,
        };
        if draft.in_order && key == Kw::Orthographic {
            draft.fit_orthographic();
        }
        return Ok(true);
    }
    if key == Kw::Mesh_camera {
        p.next()?;
        draft.camera.kind = CameraKind::Mesh(Arc::new(mesh_camera(p)?));
        return Ok(true);
    }
    Ok(frame_item(p, draft, key)? || blur_item(p, draft, key)?)
}

fn kind(key: Kw) -> Option<CameraKind> {
    Some(match key {
        Kw::Perspective => CameraKind::Perspective,
        Kw::Orthographic => CameraKind::Orthographic,
        Kw::Fisheye => CameraKind::Fisheye,
        Kw::Ultra_wide_angle => CameraKind::UltraWideAngle,
        Kw::Omnimax => CameraKind::Omnimax,
        Kw::Panoramic => CameraKind::Panoramic,
        Kw::Cylinder => CameraKind::Cylinder(1),
        Kw::Spherical => CameraKind::Spherical { v_angle: 180.0 },
        _ => return None,
    })
}

fn frame_item(p: &mut Parser, draft: &mut Draft, key: Kw) -> Result<bool> {
    let camera = &mut draft.camera;
    match key {
        Kw::Location => set_vec3(p, &mut camera.location),
        Kw::Direction => set_vec3(p, &mut camera.direction),
        Kw::Sky => set_vec3(p, &mut draft.sky),
        Kw::Up | Kw::Right => {
            draft.wrote_frame = true;
            set_vec3(p, if key == Kw::Up { &mut camera.up } else { &mut camera.right })
        }
        Kw::Look_at => {
            p.next()?;
            draft.look_at = Some(vec3(p)?);
            Ok(true)
        }
        Kw::Angle => {
            p.next()?;
            let first = float(p)?;
            let spherical = matches!(draft.camera.kind, CameraKind::Spherical { .. });
            draft.angle = Some((first, if spherical { optional_second(p)? } else { None }));
            draft.wrote_angle = true;
            Ok(true)
        }
        _ => Ok(false),
    }
}

fn blur_item(p: &mut Parser, draft: &mut Draft, key: Kw) -> Result<bool> {
    let blur = &mut draft.blur;
    match key {
        Kw::Aperture => return set(p, &mut blur.aperture),
        Kw::Confidence => return set(p, &mut blur.confidence),
        Kw::Variance => return set(p, &mut blur.variance),
        Kw::Smooth => return set_flag(p, &mut draft.smooth),
        Kw::Blur_samples => {
            p.next()?;
            let first = float(p)?.clamp(0.0, 1e9) as u32;
            let second = optional_second(p)?.map(|n| n.clamp(0.0, 1e9) as u32);
            (blur.min_samples, blur.max_samples) = second.map_or((0, first), |most| (first.min(most), most));
        }
        Kw::Focal_point => {
            p.next()?;
            draft.focal_point = Some(vec3(p)?);
        }
        Kw::Bokeh => {
            p.next()?;
            p.expect('{')?;
            if !p.accept(Kw::Pigment)? {
                return p.expected("`pigment`");
            }
            blur.bokeh = Some(pigment::block(p, &Pigment::solid(Color::BLACK))?);
            p.expect('}')?;
        }
        Kw::Normal => {
            p.next()?;
            let base: Option<Arc<Normal>> = draft.camera.normal.take();
            draft.camera.normal = normal::block(p, base.as_deref())?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// `{ rays, method [, distance] mesh { } ... [smooth] }`
fn mesh_camera(p: &mut Parser) -> Result<MeshCamera> {
    p.expect('{')?;
    let rays_per_pixel = super::util::count(p, 1, 1 << 16)?;
    let method = comma_float(p)?.clamp(0.0, 3.0) as u8;
    p.comma()?;
    let max_distance = if p.at_expression()? { float(p)? } else { 0.0 };
    let mut camera = MeshCamera { rays_per_pixel, method, max_distance, meshes: Vec::new(), smooth: false };
    super::util::until(p, '}', "mesh_camera", |p| {
        if p.accept(Kw::Smooth)? {
            camera.smooth = true;
            return Ok(true);
        }
        let span = p.span();
        let Some(object) = object::any_or_identifier(p)? else { return p.accept_punct(',') };
        let ObjectKind::Shape(shape) = &object.kind else {
            return p.error("not-a-mesh", "a mesh camera takes meshes", span);
        };
        let Shape::Mesh(mesh) = &**shape else {
            return p.error("not-a-mesh", "a mesh camera takes meshes", span);
        };
        camera.meshes.push(Placed::at(mesh.clone(), &object.parent_from_object));
        Ok(true)
    })?;
    Ok(camera)
}
