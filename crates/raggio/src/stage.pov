// The stage on which a model is shown: its place is that of the ball, which has radius 1 and is seen from a quarter
// turn to the side and a little above. The camera is right-handed, as models are.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb 0.82 }
light_source { <4, 6, 5> rgb 0.95 }
light_source { <-5, 1.5, 4> rgb 0.28 shadowless }
sphere { 0, 1
  pigment { rgb 0.7 }
  finish { ambient 0.14 diffuse 0.85 specular 0.08 roughness 0.03 }
}
camera {
  location <0.62, 0.42, 1> * Away
  right -x * image_width / image_height
  angle 30
  look_at 0
}
