// error[file-not-found] 2:41 nowhere.png
sphere { 0, 1 pigment { image_map { png "nowhere.png" } } }
