//! `now` and `datetime`: days since the start of 2000, in universal time.
use std::time::{SystemTime, UNIX_EPOCH};

/// From 1970-01-01 to 2000-01-01.
const EPOCH_SECONDS: f64 = 946_684_800.0;
const DAY: f64 = 86_400.0;

/// Days since 2000-01-01 00:00 UTC.
pub fn now() -> f64 {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(EPOCH_SECONDS, |d| d.as_secs_f64());
    (seconds - EPOCH_SECONDS) / DAY
}

const DAYS: [&str; 7] = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"];
const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];

struct Moment {
    year: i64,
    /// 0 is January.
    month: usize,
    day: i64,
    /// 0 is the first of January.
    year_day: i64,
    /// 0 is Sunday.
    week_day: i64,
    hour: i64,
    minute: i64,
    second: i64,
}

/// Formats `days` by a `strftime` pattern; unknown letters stand for themselves.
pub fn format(days: f64, pattern: &str) -> String {
    let moment = moment(days);
    let mut out = String::new();
    let mut chars = pattern.chars();
    while let Some(c) = chars.next() {
        match (c, chars.clone().next()) {
            ('%', Some(letter)) => {
                chars.next();
                out += &field(&moment, letter);
            }
            (c, _) => out.push(c),
        }
    }
    out
}

fn moment(days: f64) -> Moment {
    let total = (days.clamp(-1e6, 1e7) * DAY + 1e-5).floor() as i64;
    let (day, second) = (total.div_euclid(86_400), total.rem_euclid(86_400));
    let (year, year_day) = year_of(day);
    let lengths = [31, if leap(year) { 29 } else { 28 }, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let (mut month, mut rest) = (0, year_day);
    while rest >= lengths[month] {
        rest -= lengths[month];
        month += 1;
    }
    Moment {
        year,
        month,
        day: rest + 1,
        year_day,
        // The first day of 2000 was a Saturday.
        week_day: (day + 6).rem_euclid(7),
        hour: second / 3600,
        minute: second / 60 % 60,
        second: second % 60,
    }
}

fn leap(year: i64) -> bool {
    year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
}

/// The year of a day counted from the start of 2000, and the day in that year.
fn year_of(day: i64) -> (i64, i64) {
    let (cycle, mut day) = (day.div_euclid(146_097), day.rem_euclid(146_097));
    let mut year = 2000 + 400 * cycle;
    loop {
        let length = if leap(year) { 366 } else { 365 };
        if day < length {
            return (year, day);
        }
        day -= length;
        year += 1;
    }
}

fn field(m: &Moment, letter: char) -> String {
    let hour12 = (m.hour + 11) % 12 + 1;
    match letter {
        'Y' => m.year.to_string(),
        'C' => format!("{:02}", m.year / 100),
        'y' => format!("{:02}", m.year % 100),
        'm' => format!("{:02}", m.month + 1),
        'd' => format!("{:02}", m.day),
        'e' => format!("{:2}", m.day),
        'j' => format!("{:03}", m.year_day + 1),
        'H' => format!("{:02}", m.hour),
        'I' => format!("{hour12:02}"),
        'M' => format!("{:02}", m.minute),
        'S' => format!("{:02}", m.second),
        'p' => if m.hour < 12 { "AM" } else { "PM" }.to_owned(),
        'a' => DAYS[m.week_day as usize][..3].to_owned(),
        'A' => DAYS[m.week_day as usize].to_owned(),
        'b' | 'h' => MONTHS[m.month][..3].to_owned(),
        'B' => MONTHS[m.month].to_owned(),
        'w' => m.week_day.to_string(),
        'u' => ((m.week_day + 6) % 7 + 1).to_string(),
        'U' => format!("{:02}", (m.year_day + 7 - m.week_day) / 7),
        'W' => format!("{:02}", (m.year_day + 7 - (m.week_day + 6) % 7) / 7),
        'Z' => "UTC".to_owned(),
        'z' => "+0000".to_owned(),
        'n' => "\n".to_owned(),
        't' => "\t".to_owned(),
        '%' => "%".to_owned(),
        'F' => several(m, "Y-m-d", "-"),
        'T' | 'X' => several(m, "H:M:S", ":"),
        'R' => several(m, "H:M", ":"),
        'D' | 'x' => several(m, "m/d/y", "/"),
        'c' => format!("{} {} {} {} {}", field(m, 'a'), field(m, 'b'), field(m, 'e'), field(m, 'T'), m.year),
        other => format!("%{other}"),
    }
}

fn several(m: &Moment, letters: &str, separator: &str) -> String {
    let fields: Vec<String> =
        letters.split(separator).map(|l| field(m, l.chars().next().unwrap_or('%'))).collect();
    fields.join(separator)
}
