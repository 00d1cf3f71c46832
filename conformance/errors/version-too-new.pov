// error[version] 2:1 3.8
#version 3.8;
