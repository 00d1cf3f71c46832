//! The order of the floors: which room may use which. The table in ARCHITECTURE.md is this one in words.

use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;

/// One room of the house.
struct Room {
    name: &'static str,
    floor: u8,
    may_use: &'static [&'static str],
}

const fn room(name: &'static str, floor: u8, may_use: &'static [&'static str]) -> Room {
    Room { name, floor, may_use }
}

/// Everything below the integrators; `render` and `gpu` start from a finished scene, so the readers are not among it.
const ENGINE: &[&str] = &["math", "image", "bvh", "function", "scene", "geometry", "shading"];
const EVERYTHING: &[&str] = &[
    "math", "diag", "image", "bvh", "function", "scene", "sdl", "import", "geometry", "shading", "render",
    "gpu",
];

const ROOMS: &[Room] = &[
    room("math", 0, &[]),
    room("diag", 0, &[]),
    room("image", 1, &["math"]),
    room("bvh", 1, &["math"]),
    room("function", 1, &["math"]),
    room("scene", 2, &["math", "image", "function"]),
    room("sdl", 3, &["math", "diag", "image", "function", "scene"]),
    room("import", 3, &["math", "image", "scene"]),
    room("geometry", 3, &["math", "bvh", "function", "scene"]),
    room("shading", 4, &["math", "image", "function", "scene", "geometry"]),
    room("render", 5, ENGINE),
    room("gpu", 5, ENGINE),
    room("raggio", 6, EVERYTHING),
    room("cli", 7, &["raggio"]),
    room("studio", 7, &["raggio"]),
    room("python", 7, &["raggio"]),
    room("xtask", 8, &["raggio", "image"]),
];

/// What cargo knows about the workspace.
pub fn metadata() -> Result<Value, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--no-deps"])
        .output()
        .map_err(|e| format!("cargo metadata: {e}"))?;
    if !output.status.success() {
        return Err(format!("cargo metadata: {}", String::from_utf8_lossy(&output.stderr)));
    }
    serde_json::from_slice(&output.stdout).map_err(|e| format!("cargo metadata: {e}"))
}

/// The room's name of a package: `raggio-math` is `math`.
fn room_name(package: &str) -> &str {
    package.strip_prefix("raggio-").unwrap_or(package)
}

fn packages(metadata: &Value) -> impl Iterator<Item = &Value> {
    metadata["packages"].as_array().into_iter().flatten()
}

/// Name and folder of each package of the workspace.
pub fn rooms(metadata: &Value) -> Vec<(String, PathBuf)> {
    packages(metadata)
        .filter_map(|p| {
            let manifest = PathBuf::from(p["manifest_path"].as_str()?);
            Some((room_name(p["name"].as_str()?).to_string(), manifest.parent()?.to_path_buf()))
        })
        .collect()
}

/// Dependencies (normal, build and test alike) that break the order.
pub fn check(metadata: &Value) -> Vec<String> {
    let members: Vec<&str> = packages(metadata).filter_map(|p| p["name"].as_str()).collect();
    let mut faults = Vec::new();
    for package in packages(metadata) {
        let user = room_name(package["name"].as_str().unwrap_or_default());
        let Some(room) = ROOMS.iter().find(|r| r.name == user) else {
            faults.push(format!(
                "{user}: stands on no floor; add it to xtask/src/tidy/floors.rs and ARCHITECTURE.md"
            ));
            continue;
        };
        for dependency in package["dependencies"].as_array().into_iter().flatten() {
            let name = dependency["name"].as_str().unwrap_or_default();
            if members.contains(&name) {
                faults.extend(fault(room, room_name(name)));
            }
        }
    }
    faults
}

/// Why `user` must not depend on `used`, if it must not.
fn fault(user: &Room, used: &str) -> Option<String> {
    let below = ROOMS.iter().find(|r| r.name == used).is_some_and(|r| r.floor < user.floor);
    if below && user.may_use.contains(&used) {
        return None;
    }
    Some(format!("{} (floor {}) must not depend on {used}; it may use: {}", user.name, user.floor, {
        if user.may_use.is_empty() { "nothing".to_string() } else { user.may_use.join(", ") }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn depends(user: &str, used: &str) -> Vec<String> {
        check(&json!({"packages": [
            {"name": user, "dependencies": [{"name": used}, {"name": "serde"}]},
            {"name": used, "dependencies": []},
        ]}))
    }

    #[test]
    fn the_table_itself_keeps_the_order() {
        for user in ROOMS {
            for used in user.may_use {
                let below = ROOMS.iter().find(|r| r.name == *used).expect("listed room");
                assert!(below.floor < user.floor, "{} may use {used}", user.name);
            }
        }
    }

    #[test]
    fn downwards_is_allowed_and_sideways_or_upwards_is_not() {
        assert!(depends("raggio-geometry", "raggio-bvh").is_empty());
        assert_eq!(depends("raggio-geometry", "raggio-sdl").len(), 1, "same floor");
        assert_eq!(depends("raggio-math", "raggio-scene").len(), 1, "upwards");
        assert_eq!(depends("raggio-cli", "raggio-render").len(), 1, "a door sees the façade only");
        assert_eq!(depends("raggio-attic", "raggio-math").len(), 1, "unknown room");
    }
}
