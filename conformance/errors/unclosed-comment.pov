// error[unclosed-comment] 2:1 */
/* no end
sphere { 0, 1 }
