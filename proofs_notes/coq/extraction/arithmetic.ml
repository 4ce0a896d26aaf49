(* arithmetic.encode and arithmetic.decode by the coder that is proved: ORCL-OP-4. *)

open Protocol

(* ** Numbers between Coq and OCaml *)

let rec positive n =
  if n = 1 then Coder.XH
  else if n mod 2 = 0 then Coder.XO (positive (n / 2))
  else Coder.XI (positive (n / 2))

let small n = if n = 0 then Coder.Z0 else if n > 0 then Coder.Zpos (positive n) else Coder.Zneg (positive (-n))
let ten = small 10

let big digits =
  let negative = digits.[0] = '-' in
  let n = ref Coder.Z0 in
  String.iter
    (fun c -> if c <> '-' then n := Coder.Z.add (Coder.Z.mul ten !n) (small (Char.code c - 48)))
    digits;
  if negative then Coder.Z.opp !n else !n

let rec int_of_positive p =
  match p with
  | Coder.XH -> 1
  | Coder.XO p -> 2 * int_of_positive p
  | Coder.XI p -> (2 * int_of_positive p) + 1

let int_of z =
  match z with Coder.Z0 -> 0 | Coder.Zpos p -> int_of_positive p | Coder.Zneg p -> -int_of_positive p

let nat n =
  let rec go n found = if n = 0 then found else go (n - 1) (Coder.S found) in
  go n Coder.O

let number found = big (integer found)

(* ** Requests *)

let model_of found =
  let numbers l = List.map number (list l) in
  match text (key "kind" found) with
  | "static" ->
    (match fields [ "kind"; "frequencies" ] found with
     | [ _; fs ] -> Coder.Static (numbers fs)
     | _ -> assert false)
  | "uniform" ->
    (match fields [ "kind"; "size" ] found with
     | [ _; n ] -> Coder.Uniform (number n)
     | _ -> assert false)
  | "adaptive" ->
    (match fields [ "kind"; "frequencies"; "increment"; "limit" ] found with
     | [ _; fs; increment; limit ] -> Coder.Adaptive (numbers fs, number increment, number limit)
     | _ -> assert false)
  | _ -> raise (Form "a strange kind of model")

let reject (why, clause) blamed =
  let reason = match why with
    | Coder.Bad_table -> "bad-table"
    | Coder.Not_in_alphabet -> "not-in-alphabet"
    | Coder.Truncated_bits -> "truncated-bits"
    | Coder.Trailing_bits -> "trailing-bits"
    | Coder.Not_canonical -> "not-canonical" in
  let at = match blamed with
    | None -> ""
    | Some z -> Printf.sprintf {|"symbol":%d|} (int_of z) in
  Reject { reason; clause; at }

(* The clause by which a coder rejects. *)
let coder_clause why =
  match why with
  | Coder.Bad_table -> "INFO-MODEL-6"
  | Coder.Not_in_alphabet -> "INFO-MODEL-5"
  | Coder.Truncated_bits -> "ARITH-STRICT-2"
  | Coder.Trailing_bits -> "ARITH-STRICT-3"
  | Coder.Not_canonical -> "ARITH-STRICT-4"

(* The clause by which a model is rejected: that of its table if this alone is bad. *)
let model_clause model =
  match model with
  | Coder.Adaptive (table, _, _) ->
    (match Coder.checked (Coder.Static table) with
     | Coder.Accepted _ -> "INFO-ADAPT-3"
     | Coder.Rejected _ -> "INFO-STATIC-3")
  | _ -> "INFO-STATIC-3"

(* What follows if the coder is the proved one, and the model passes its checks. *)
let with_model coder model go =
  match text coder with
  | "arithmetic" ->
    (match Coder.checked model with
     | Coder.Accepted model -> go model
     | Coder.Rejected (why, blamed) -> reject (why, model_clause model) blamed)
  | ("range" | "rans") as name -> Unsupported ("coder." ^ name)
  | _ -> raise (Form "a strange coder")

let encode given =
  match fields [ "coder"; "model"; "symbols" ] given with
  | [ coder; model; symbols ] ->
    let model = model_of model and symbols = List.map number (list symbols) in
    with_model coder model (fun model ->
        match Coder.encode_with model symbols with
        | Coder.Accepted bits -> Ok (bits_form bits)
        | Coder.Rejected (why, blamed) -> reject (why, coder_clause why) blamed)
  | _ -> assert false

let decode given =
  match fields [ "coder"; "model"; "bits"; "count" ] given with
  | [ coder; model; bits; wanted ] ->
    let model = model_of model and bits = bits_of bits and wanted = count wanted in
    if wanted > max_symbols then Unsupported "max_symbols"
    else
      with_model coder model (fun model ->
          match bits with
          | Error rejection -> rejection
          | Result.Ok bits ->
            (match Coder.decode_with model bits (nat wanted) with
             | Coder.Accepted symbols ->
               let symbols = List.map (fun s -> string_of_int (int_of s)) symbols in
               Ok (Printf.sprintf {|{"symbols":[%s]}|} (String.concat "," symbols))
             | Coder.Rejected (why, blamed) -> reject (why, coder_clause why) blamed))
  | _ -> assert false
