(* An adapter made of proved functions: spec/09-conformance.md. Reading, writing and the packing of
   bits are plain OCaml; what is between them was extracted from Coq. *)

open Protocol

(* Every operation that there is a proof for. One more is a line here, and a name in [caps]. *)
let operations : (string * (Json.value -> answer)) list =
  [ ("arithmetic.encode", Arithmetic.encode);
    ("arithmetic.decode", Arithmetic.decode);
    ("word.encode", Words.encode);
    ("word.decode", Words.decode) ]

let caps =
  Printf.sprintf
    {|{"handles":true,"boundaries":"none","components":false,"max_faces":%d,"max_symbols":%d,"trace":[],"codes":[],"coders":["arithmetic"]}|}
    max_symbols max_symbols

let introduction =
  let names = "echo" :: List.map fst operations in
  Printf.sprintf {|{"protocol":1,"name":"proved","version":"1","language":"coq","ops":[%s],"caps":%s}|}
    (String.concat "," (List.map Json.quote names))
    caps

(* What a line is answered; nothing to bye. *)
let answer line =
  match Json.line line with
  | exception Json.Bad why -> Some (failure "null" why)
  | entries ->
    let value name = Option.map snd (List.assoc_opt name entries) in
    let only names = List.for_all (fun (k, _) -> List.mem k names) entries in
    let id = match value "id" with
      | Some (Json.Number digits) ->
        (match whole digits with n when n >= 0 -> Some (string_of_int n) | _ -> None | exception Form _ -> None)
      | _ -> None in
    (match (value "op", id) with
     | Some (Json.String "bye"), _ -> None
     | Some (Json.String op), Some id ->
       Some
         (try
            match op with
            | "hello" ->
              let need = [ "op"; "id"; "protocol"; "spec"; "suite" ] in
              if not (only need && List.length entries = 5) then raise (Form "a strange hello");
              (match (value "protocol", value "spec", value "suite") with
               | Some (Json.Number protocol), Some (Json.String _), Some (Json.String _) ->
                 reply id (if protocol = "1" then Ok introduction else Unsupported "protocol")
               | _ -> raise (Form "a strange hello"))
            | "echo" ->
              (match List.assoc_opt "in" entries with
               | Some (text, Json.Object _) -> reply id (Ok text)
               | _ -> raise (Form "no input"))
            | _ ->
              (match List.assoc_opt op operations with
               | None -> reply id (Unsupported op)
               | Some operation ->
                 if not (only [ "op"; "id"; "in"; "trace" ]) then raise (Form "a strange key");
                 (match value "trace" with
                  | None | Some (Json.String ("none" | "full")) -> ()
                  | Some _ -> raise (Form "a strange trace"));
                 (match value "in" with
                  | Some input -> reply id (operation input)
                  | None -> raise (Form "no input")))
          with
          | Form why -> failure id why
          | Stack_overflow -> failure id "out of stack")
     | _, Some id -> Some (failure id "no operation")
     | _, None -> Some (failure "null" "no id"))

let () =
  let rec go () =
    match input_line stdin with
    | exception End_of_file -> ()
    | line ->
      (match answer line with
       | None -> ()
       | Some text -> print_string text; print_char '\n'; flush stdout; go ()) in
  go ()
