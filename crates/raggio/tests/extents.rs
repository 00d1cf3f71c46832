//! `min_extent` and `max_extent` of all kinds of objects, against what POV-Ray tells of them.
use raggio::SceneOptions;

#[test]
fn extents_are_those_of_pov_ray() {
    let mut faults = Vec::new();
    for line in include_str!("data/extents.txt").lines() {
        let (object, box_) = line.split_once(" | ").unwrap();
        let (min, max) = box_.split_once(' ').unwrap();
        let text = format!(
            "#version 3.7;
            #declare O = {object}
            #macro Off(A, B) (vlength(A - B) > 1e-4 * max(1, vlength(B))) #end
            #if (Off(min_extent(O), <{min}>) | Off(max_extent(O), <{max}>))
                #error concat(vstr(3, min_extent(O), \",\", 0, 4), \" \", vstr(3, max_extent(O), \",\", 0, 4))
            #end"
        );
        if let Err(failure) = raggio::load(&SceneOptions::text("test.pov", text)) {
            let said = failure.render();
            faults.push(format!("{line}\n    {}", said.lines().next().unwrap_or_default()));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
