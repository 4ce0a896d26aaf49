(* JSON, read by hand, as no library can be supposed. Numbers keep their digits. *)

type value =
  | Null
  | Bool of bool
  | Number of string
  | String of string
  | List of value list
  | Object of (string * value) list

exception Bad of string

(* The characters of a code point in UTF-8. *)
let add_point out point =
  let add n = Buffer.add_char out (Char.chr n) in
  if point < 0x80 then add point
  else if point < 0x800 then (add (0xC0 lor (point lsr 6)); add (0x80 lor (point land 63)))
  else if point < 0x10000 then begin
    add (0xE0 lor (point lsr 12));
    add (0x80 lor ((point lsr 6) land 63));
    add (0x80 lor (point land 63))
  end else begin
    add (0xF0 lor (point lsr 18));
    add (0x80 lor ((point lsr 12) land 63));
    add (0x80 lor ((point lsr 6) land 63));
    add (0x80 lor (point land 63))
  end

(* A text, and how far it is read. *)
type source = { text : string; mutable at : int }

let peek s = if s.at < String.length s.text then s.text.[s.at] else '\000'
let skip s = s.at <- s.at + 1

let rec space s =
  match peek s with
  | ' ' | '\t' | '\n' | '\r' -> skip s; space s
  | _ -> ()

let expect s c = if peek s = c then skip s else raise (Bad (Printf.sprintf "%C at %d" c s.at))

let word s letters value =
  String.iter (expect s) letters;
  value

let rec digits s = match peek s with '0' .. '9' -> skip s; digits s | _ -> ()

let some_digits s =
  let start = s.at in
  digits s;
  if s.at = start then raise (Bad "a number without digits")

let number s =
  let start = s.at in
  if peek s = '-' then skip s;
  if peek s = '0' then skip s else some_digits s;
  if peek s = '.' then (skip s; some_digits s);
  (match peek s with
   | 'e' | 'E' ->
     skip s;
     (match peek s with '+' | '-' -> skip s | _ -> ());
     some_digits s
   | _ -> ());
  Number (String.sub s.text start (s.at - start))

let hex4 s =
  let digit c = match c with
    | '0' .. '9' -> Char.code c - 48
    | 'a' .. 'f' -> Char.code c - 87
    | 'A' .. 'F' -> Char.code c - 55
    | _ -> raise (Bad "an escape without four digits") in
  let take () = let d = digit (peek s) in skip s; d in
  let a = take () in
  let b = take () in
  let c = take () in
  let d = take () in
  (a lsl 12) lor (b lsl 8) lor (c lsl 4) lor d

let escape s out =
  let c = peek s in
  skip s;
  match c with
  | '"' | '\\' | '/' -> Buffer.add_char out c
  | 'b' -> Buffer.add_char out '\b'
  | 'f' -> Buffer.add_char out '\012'
  | 'n' -> Buffer.add_char out '\n'
  | 'r' -> Buffer.add_char out '\r'
  | 't' -> Buffer.add_char out '\t'
  | 'u' ->
    let high = hex4 s in
    if high land 0xFC00 = 0xD800 then begin
      expect s '\\';
      expect s 'u';
      let low = hex4 s in
      if low land 0xFC00 <> 0xDC00 then raise (Bad "half a surrogate pair");
      add_point out (0x10000 + ((high land 0x3FF) lsl 10) + (low land 0x3FF))
    end
    else if high land 0xFC00 = 0xDC00 then raise (Bad "half a surrogate pair")
    else add_point out high
  | _ -> raise (Bad "a strange escape")

let quoted s =
  expect s '"';
  let out = Buffer.create 16 in
  let rec go () =
    if s.at >= String.length s.text then raise (Bad "a string without an end");
    match peek s with
    | '"' -> skip s
    | '\\' -> skip s; escape s out; go ()
    | c when c < ' ' -> raise (Bad "a control character in a string")
    | c -> skip s; Buffer.add_char out c; go () in
  go ();
  Buffer.contents out

(* What stands between brackets, separated by commas. *)
let items s closing item =
  skip s;
  space s;
  if peek s = closing then (skip s; [])
  else begin
    let rec go found =
      let found = item () :: found in
      space s;
      if peek s = ',' then (skip s; go found) else (expect s closing; List.rev found) in
    go []
  end

let rec value s =
  space s;
  match peek s with
  | 'n' -> word s "null" Null
  | 't' -> word s "true" (Bool true)
  | 'f' -> word s "false" (Bool false)
  | '"' -> String (quoted s)
  | '[' -> List (items s ']' (fun () -> value s))
  | '{' -> Object (items s '}' (fun () -> let k, _, v = entry s in (k, v)))
  | _ -> number s

(* A key, where its value stands in the text, and the value. *)
and entry s =
  space s;
  let key = quoted s in
  space s;
  expect s ':';
  space s;
  let start = s.at in
  let found = value s in
  (key, (start, s.at - start), found)

(* The entries of the one object that a line is, each with its own text. *)
let line text =
  let s = { text; at = 0 } in
  space s;
  if peek s <> '{' then raise (Bad "not an object");
  let whole = items s '}' (fun () -> entry s) in
  space s;
  if s.at < String.length text then raise (Bad "more than one value");
  List.map (fun (key, (start, size), found) -> (key, (String.sub text start size, found))) whole

let quote text =
  let out = Buffer.create (String.length text + 2) in
  Buffer.add_char out '"';
  String.iter
    (fun c ->
      match c with
      | '"' | '\\' -> Buffer.add_char out '\\'; Buffer.add_char out c
      | c when c < ' ' -> Buffer.add_string out (Printf.sprintf "\\u%04x" (Char.code c))
      | c -> Buffer.add_char out c)
    text;
  Buffer.add_char out '"';
  Buffer.contents out
