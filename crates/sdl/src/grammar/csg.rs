//! Objects made of objects (shapes spec, section 8).
use std::sync::Arc;

use raggio_scene::{Csg, Object, ObjectKind};

use super::{interior, modifiers, object};
use crate::parser::{Parser, Result};

/// `union { ... }`, also `composite`.
pub fn union(p: &mut Parser) -> Result<Object> {
    block(p, "union", Csg::Union)
}

/// `merge { ... }`
pub fn merge(p: &mut Parser) -> Result<Object> {
    block(p, "merge", Csg::Merge)
}

/// `intersection { ... }`
pub fn intersection(p: &mut Parser) -> Result<Object> {
    block(p, "intersection", Csg::Intersection)
}

/// `difference { ... }`
pub fn difference(p: &mut Parser) -> Result<Object> {
    block(p, "difference", Csg::Difference { cutaway_textures: false })
}

/// Members first, then modifiers.
fn block(p: &mut Parser, what: &str, op: Csg) -> Result<Object> {
    let span = p.span();
    let (mut members, mut csg) = (Vec::new(), None);
    p.block(what, |p| {
        if csg.is_none() && member(p, op, &mut members)? {
            return Ok(true);
        }
        let csg = csg.get_or_insert_with(|| combined(op, std::mem::take(&mut members)));
        modifiers::modifier(p, csg)
    })?;
    let csg = csg.unwrap_or_else(|| combined(op, members));
    if matches!(&csg.kind, ObjectKind::Csg { children, .. } if children.len() < 2) {
        p.warn("lonely-csg", format!("a {what} should have at least 2 objects"), span);
    }
    Ok(object::finished(csg))
}

fn member(p: &mut Parser, op: Csg, members: &mut Vec<Arc<Object>>) -> Result<bool> {
    let span = p.span();
    let Some(object) = object::any_or_identifier(p)? else { return Ok(false) };
    if !matches!(op, Csg::Union | Csg::Merge) && object::is_patch(&object) {
        p.warn("patch-in-csg", "patch objects have no inside and are not allowed in an intersection", span);
    }
    members.push(Arc::new(object));
    Ok(true)
}

fn combined(op: Csg, mut members: Vec<Arc<Object>>) -> Object {
    let interior = interior::take_legacy(&mut members);
    let mut solids = members.iter().filter(|member| !matches!(member.kind, ObjectKind::Light(_))).peekable();
    let no_shadow = op == Csg::Union && solids.peek().is_some() && solids.all(|member| member.no_shadow);
    let mut object = Object::new(ObjectKind::Csg { op, children: Arc::new(members) });
    (object.no_shadow, object.interior) = (no_shadow, interior);
    object
}
