(* word.encode and word.decode by the functions that are proved, for one closed component of any genus:
   ORCL-OP-5. That the faces given are a closed surface is tested here, in plain OCaml; what follows is
   proved of every such surface: the walk (Traversal.v) and the way back (Decoder.v, Rebuild.v). *)

open Protocol

let reject reason = Reject { reason; clause = ""; at = "" }

let letter c =
  match c with
  | 'C' -> Some Sphere.SC
  | 'L' -> Some Sphere.SL
  | 'E' -> Some Sphere.SE
  | 'R' -> Some Sphere.SR
  | 'S' -> Some Sphere.SS
  | _ -> None

let face ((x, y), z) = Printf.sprintf "[%d,%d,%d]" x y z
let largest_vertex faces = List.fold_left (fun m ((x, y), z) -> max m (max x (max y z))) (-1) faces

let shape given =
  match fields [ "faces"; "vertices" ] given with
  | [ faces; vertices ] ->
    let number v = Option.value (int_of_string_opt (integer v)) ~default:(-1) in
    let triple f = match list f with
      | [ x; y; z ] -> ((number x, number y), number z)
      | _ -> raise (Form "not three vertices") in
    (List.map triple (list faces), number vertices)
  | _ -> assert false

(* What is wrong with faces: CPLX's rules for a closed oriented surface. *)
let fault faces vertices =
  let apex = Hashtbl.create 64 and degree = Hashtbl.create 64 and some_edge = Hashtbl.create 64 in
  let bad ((x, y), z) =
    let outside v = v < 0 || v >= vertices in
    let run a b c =
      let twice = Hashtbl.mem apex (a, b) in
      Hashtbl.replace apex (a, b) c;
      Hashtbl.replace some_edge a b;
      Hashtbl.replace degree a (1 + Option.value (Hashtbl.find_opt degree a) ~default:0);
      twice in
    outside x || outside y || outside z || x = y || y = z || z = x
    || List.mem true [ run x y z; run y z x; run z x y ] in
  (* The faces around v, from one on, are all of its faces. *)
  let pinched v =
    let first = Hashtbl.find some_edge v in
    let rec turn a n = if n > 0 && a = first then n else turn (Hashtbl.find apex (v, a)) (n + 1) in
    turn first 0 <> Hashtbl.find degree v in
  if faces = [] then Some (reject "empty-mesh")
  else if List.exists bad faces then Some (reject "")
  else if Hashtbl.length degree < vertices then Some (reject "isolated-vertex")
  else if Hashtbl.fold (fun (a, b) _ open_ -> open_ || not (Hashtbl.mem apex (b, a))) apex false then
    Some (Unsupported "boundaries")
  else if Hashtbl.fold (fun v _ found -> found || pinched v) degree false then
    Some (reject "pinched-vertex")
  else None

let letter_of s =
  match s with
  | Sphere.SC -> 'C'
  | Sphere.SL -> 'L'
  | Sphere.SE -> 'E'
  | Sphere.SR -> 'R'
  | Sphere.SS -> 'S'

(* ** Decoding *)

(* More than one component: not done, unless the word ends within one. *)
let components letters records =
  let numbers = List.map (fun ((s, _), _) -> s) records in
  let rec go open_gates seen left =
    match left with
    | [] -> open_gates = 1
    | x :: rest ->
      let now = match x with
        | Sphere.SS -> if List.mem seen numbers then open_gates else open_gates + 1
        | Sphere.SE -> open_gates - 1
        | _ -> open_gates in
      go (if now = 0 then 1 else now) (if x = Sphere.SS then seen + 1 else seen) rest in
  if go 1 0 letters then Unsupported "components" else reject "unfinished-word"

(* A record: EB-HANDLE-2 to EB-HANDLE-4. *)
let record found =
  match fields [ "kind"; "s"; "at"; "side" ] found with
  | [ kind; s; at; side ] ->
    let number v = Option.value (int_of_string_opt (integer v)) ~default:(-1) in
    let place = match text side with
      | "right" -> Sphere.At_right
      | "left" -> Sphere.At_left
      | _ -> raise (Form "a strange side") in
    (match text kind with
     | "handle" | "boundary" -> (text kind, ((number s, number at), place))
     | _ -> raise (Form "a strange kind"))
  | _ -> assert false

(* Where the first component ends, if it does: EB-GRAMMAR-3. *)
let ends letters records =
  let numbers = List.map (fun ((s, _), _) -> s) records in
  let rec go open_gates seen i left =
    match left with
    | [] -> None
    | x :: rest ->
      let now = match x with
        | Sphere.SS -> if List.mem seen numbers then open_gates else open_gates + 1
        | Sphere.SE -> open_gates - 1
        | _ -> open_gates in
      if now = 0 then Some (i + 1) else go now (if x = Sphere.SS then seen + 1 else seen) (i + 1) rest in
  go 1 0 0 letters

(* A stream with handles is decoded by Rebuild.v. It is valid if what it gives is a closed surface and
   has this very stream: that surfaces come back is proved, so no stream of one is refused. *)
let decode_handles letters records =
  match Sphere.decode_stream letters records with
  | None -> reject ""
  | Some faces ->
    let vertices = largest_vertex faces + 1 in
    (match if Sphere.simple faces then fault faces vertices else Some (reject "double-edge") with
     | Some _ -> reject ""
     | None ->
       (match Sphere.encode faces with
        | Some (steps, _)
          when List.map fst steps = letters && Sphere.records_of steps = records
               && List.length steps + 1 = List.length faces ->
          Ok
            (Printf.sprintf {|{"faces":[%s],"vertices":%d}|}
               (String.concat "," (List.map face faces)) vertices)
        | _ -> reject ""))

let decode given =
  match fields [ "word"; "handles"; "components_with_boundary" ] given with
  | [ word; handles; boundary ] ->
    let word = text word and boundary = integer boundary in
    let handles = List.map record (list handles) in
    let letters = List.map letter (List.of_seq (String.to_seq word)) in
    let symbols = List.length (List.filter (fun x -> x = Some Sphere.SS) letters) in
    let out_of_range (_, ((s, at), _)) = s < 0 || s >= symbols || at < 0 in
    let rec increasing numbers =
      match numbers with x :: (y :: _ as rest) -> x < y && increasing rest | _ -> true in
    if word = "" then reject "empty-word"
    else if List.mem None letters then reject "unknown-symbol"
    else if not (increasing (List.map (fun (_, ((s, _), _)) -> s) handles)) then reject "record-order"
    else if List.exists out_of_range handles then reject "record-out-of-range"
    else if boundary.[0] = '-' then reject "too-few-components"
    else if boundary <> "0" then Unsupported "boundaries"
    else if String.length word > max_symbols then Unsupported "max_symbols"
    else begin
      let letters = List.filter_map Fun.id letters and records = List.map snd handles in
      match ends letters records with
      | None -> reject "unfinished-word"
      | Some n when n < List.length letters -> components letters records
      | Some _ when List.exists (fun (kind, _) -> kind = "boundary") handles -> reject "not-a-curve"
      | Some _ when records <> [] -> decode_handles letters records
      | Some _ ->
        (match Sphere.decode letters with
         | None -> reject ""
         | Some faces ->
           Ok
             (Printf.sprintf {|{"faces":[%s],"vertices":%d}|}
                (String.concat "," (List.map face faces))
                (largest_vertex faces + 1)))
    end
  | _ -> assert false

(* ** Encoding *)

let written ((s, at), place) =
  let side = match place with Sphere.At_left -> "left" | _ -> "right" in
  Printf.sprintf {|{"kind":"handle","s":%d,"at":%d,"side":"%s"}|} s at side

let encode given =
  let faces, vertices = shape given in
  if List.length faces > max_symbols then Unsupported "max_faces"
  else
    match fault faces vertices with
    | Some answer -> answer
    | None ->
      (match Sphere.encode faces with
       | None -> failwith "a walk without an end"
       | Some (steps, _) when List.length steps + 1 < List.length faces -> Unsupported "components"
       | Some (steps, _) ->
         let word = String.of_seq (List.to_seq (List.map (fun (s, _) -> letter_of s) steps)) in
         let order = List.map string_of_int (Sphere.order faces steps) in
         Ok
           (Printf.sprintf
              {|{"word":"%s","handles":[%s],"components_with_boundary":0,"vertex_order":[%s]}|} word
              (String.concat "," (List.map written (Sphere.records_of steps)))
              (String.concat "," order)))
