// An adapter to begin with: it does `echo`, and says so of nothing else.
//
// One request a line comes on standard input, one reply a line goes to standard output; print
// anything else to standard error. What the operations take and give: spec/09-conformance.md.
//
// Rust's own library has no JSON. `find` gives the text of a value of an object, unread; that is
// enough to begin with, as requests are well formed. For more than echo take serde_json.
use std::io::{self, BufRead, Write};

const PROTOCOL: &str = "1";

const HELLO: &str = concat!(
    r#"{"protocol":1,"name":"my mesh library","version":"0.1","language":"rust","#,
    r#""ops":["echo"],"#, // then "word.decode", …
    r#""caps":{"handles":false,"boundaries":"none","components":false,"#,
    r#""max_faces":1000000,"max_symbols":1000000}}"#
);

fn past_space(text: &[u8], mut at: usize) -> usize {
    while at < text.len() && text[at].is_ascii_whitespace() {
        at += 1;
    }
    at
}

fn past_string(text: &[u8], mut at: usize) -> usize {
    at += 1;
    while at < text.len() && text[at] != b'"' {
        at += if text[at] == b'\\' { 2 } else { 1 };
    }
    (at + 1).min(text.len())
}

fn past_value(text: &[u8], mut at: usize) -> usize {
    let mut depth = 0;
    while at < text.len() {
        match text[at] {
            b'"' => {
                at = past_string(text, at);
                if depth == 0 {
                    return at;
                }
                continue;
            }
            b',' | b'}' | b']' if depth == 0 => return at,
            b'{' | b'[' => depth += 1,
            b'}' | b']' => {
                depth -= 1;
                if depth == 0 {
                    return at + 1;
                }
            }
            _ => {}
        }
        at += 1;
    }
    at
}

/// The text of a key's value in an object; empty if the key is not there.
fn find<'a>(object: &'a str, key: &str) -> &'a str {
    let text = object.as_bytes();
    let mut at = past_space(text, past_space(text, 0) + 1);
    while at < text.len() && text[at] == b'"' {
        let name = at + 1;
        at = past_string(text, at);
        let found = &text[name..at - 1] == key.as_bytes();
        let value = past_space(text, past_space(text, at) + 1);
        at = past_value(text, value);
        if found {
            return object[value..at].trim_end();
        }
        at = past_space(text, at);
        if at < text.len() && text[at] == b',' {
            at = past_space(text, at + 1);
        }
    }
    ""
}

/// One of ok, reject, unsupported, error.
fn answer(request: &str) -> String {
    let operation = find(request, "op");
    match operation {
        r#""hello""# if find(request, "protocol") != PROTOCOL => {
            r#""unsupported":{"cap":"protocol"}"#.to_string()
        }
        r#""hello""# => format!(r#""ok":{HELLO}"#),
        r#""echo""# => format!(r#""ok":{}"#, find(request, "in")),
        // Here your operations join. Bad input is
        //   "reject":{"class":"malformed","reason":"…"}    (or "invalid", "unsupported", "limit")
        _ => format!(r#""unsupported":{{"cap":{operation}}}"#),
    }
}

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let request = line?;
        if find(&request, "op") == r#""bye""# {
            break;
        }
        writeln!(out, r#"{{"id":{},{}}}"#, find(&request, "id"), answer(&request))?;
        out.flush()?;
    }
    Ok(())
}
