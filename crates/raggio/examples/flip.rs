//! scratch: mean FLIP of pairs given on stdin
use std::io::BufRead;
fn main() {
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut parts = line.split_whitespace();
        let (a, b) = (parts.next().unwrap(), parts.next().unwrap());
        let read = |p: &str| std::fs::read(p).ok().and_then(|x| raggio::image::decode(&x, None).ok());
        match (read(a), read(b)) {
            (Some(x), Some(y)) => match raggio::image::compare(&x, &y) {
                Ok(c) => println!("{a} {b} {:.5}", c.mean_flip),
                Err(_) => println!("{a} {b} size"),
            },
            _ => println!("{a} {b} missing"),
        }
    }
}
