(* Requests and replies: spec/09-conformance.md, sections 9.1 and 9.2. *)

open Json

(* The most symbols decoded for a request: Coq's functions are not made for deep stacks, nor fast. *)
let max_symbols = 4096

(* What an operation comes to: ORCL-REPLY-1. Texts are JSON already. *)
type answer =
  | Ok of string
  | Reject of { reason : string; clause : string; at : string }
  | Unsupported of string

(* An input that has not the form of its operation: ORCL-REPLY-4. *)
exception Form of string

(* CONV-RESULT-3. *)
let class_of reason =
  match reason with
  | "trailing-bits" | "truncated-bits" | "not-canonical" -> "malformed"
  | _ -> "invalid"

let reply id answer =
  match answer with
  | Ok result -> Printf.sprintf {|{"id":%s,"ok":%s}|} id result
  | Reject { reason; clause; at } ->
    Printf.sprintf {|{"id":%s,"reject":{"class":"%s","reason":"%s","at":{%s},"clause":"%s"}}|} id
      (class_of reason) reason at clause
  | Unsupported cap -> Printf.sprintf {|{"id":%s,"unsupported":{"cap":%s}}|} id (quote cap)

let failure id message = Printf.sprintf {|{"id":%s,"error":{"message":%s}}|} id (quote message)

(* ** What values must be *)

(* The values of an object under just these keys, in their order. *)
let fields keys found =
  match found with
  | Object entries ->
    if List.length entries <> List.length keys then raise (Form "a key is missing or strange");
    List.map
      (fun key ->
        match List.assoc_opt key entries with
        | Some v -> v
        | None -> raise (Form ("no key " ^ key)))
      keys
  | _ -> raise (Form "not an object")

let key name found =
  match found with
  | Object entries when List.mem_assoc name entries -> List.assoc name entries
  | _ -> raise (Form ("no key " ^ name))

let text found = match found with String s -> s | _ -> raise (Form "not a string")
let list found = match found with List l -> l | _ -> raise (Form "not a list")
let largest = 1 lsl 53

let whole digits =
  let good = String.length digits <= 17 && String.for_all (fun c -> c = '-' || ('0' <= c && c <= '9')) digits in
  match if good then int_of_string_opt digits else None with
  | Some n when abs n <= largest -> n
  | _ -> raise (Form "not an integer up to 2^53")

(* ORCL-VALUE-1: an integer, by its digits. *)
let integer found =
  match found with
  | Number digits -> string_of_int (whole digits)
  | String digits ->
    let from = if String.length digits > 0 && digits.[0] = '-' then 1 else 0 in
    let size = String.length digits - from in
    let rest = String.sub digits from size in
    if size < 16 || size > 1000 || rest.[0] = '0' || not (String.for_all (fun c -> '0' <= c && c <= '9') rest)
    then raise (Form "not an integer");
    digits
  | _ -> raise (Form "not an integer")

let count found =
  match found with
  | Number digits -> let n = whole digits in if n < 0 then raise (Form "negative") else n
  | _ -> raise (Form "not a count")

(* ORCL-VALUE-2: bytes. *)
let bytes found =
  let hex = text found in
  let digit c = match c with
    | '0' .. '9' -> Char.code c - 48
    | 'a' .. 'f' -> Char.code c - 87
    | _ -> raise (Form "not hexadecimal") in
  if String.length hex mod 2 <> 0 then raise (Form "half a byte");
  Array.init (String.length hex / 2) (fun i -> (16 * digit hex.[2 * i]) + digit hex.[(2 * i) + 1])

(* Bits, packed: ARITH-BITS-2. *)
let bits_form bits =
  let length = List.length bits in
  let data = Bytes.make ((length + 7) / 8) '\000' in
  List.iteri
    (fun i b ->
      if b then
        let old = Char.code (Bytes.get data (i / 8)) in
        Bytes.set data (i / 8) (Char.chr (old lor (128 lsr (i mod 8)))))
    bits;
  let hex = String.concat "" (List.map (Printf.sprintf "%02x") (List.map Char.code (List.of_seq (Bytes.to_seq data)))) in
  Printf.sprintf {|{"hex":"%s","length":%d}|} hex length

(* Bits from outside, or their rejection: ARITH-BITS-3. *)
let bits_of found =
  match fields [ "hex"; "length" ] found with
  | [ hex; length ] ->
    let data = bytes hex and length = count length in
    let size = (length + 7) / 8 and given = Array.length data in
    let clause = "ARITH-BITS-3" in
    let at byte = Printf.sprintf {|"byte":%d|} byte in
    if given < size then Error (Reject { reason = "truncated-bits"; clause; at = "" })
    else if given > size then Error (Reject { reason = "trailing-bits"; clause; at = at size })
    else if length mod 8 <> 0 && data.(size - 1) land (255 lsr (length mod 8)) <> 0 then
      Error (Reject { reason = "trailing-bits"; clause; at = at (size - 1) })
    else Result.Ok (List.init length (fun i -> data.(i / 8) land (128 lsr (i mod 8)) <> 0))
  | _ -> assert false
