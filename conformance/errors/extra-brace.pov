// error[unexpected] 3:1 }
sphere { 0, 1 }
}
