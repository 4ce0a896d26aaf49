(* word.encode and word.decode by the functions that are proved, for one closed component without
   records: ORCL-OP-5. That the faces given are a closed surface is tested here, in plain OCaml; what
   follows is proved of every such surface (Traversal.v), and the round trip of spheres. *)

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

let decode given =
  match fields [ "word"; "handles"; "components_with_boundary" ] given with
  | [ word; handles; boundary ] ->
    let word = text word and handles = list handles and boundary = integer boundary in
    let letters = List.map letter (List.of_seq (String.to_seq word)) in
    if List.mem None letters then reject "unknown-symbol"
    else if boundary.[0] = '-' then reject "too-few-components"
    else if boundary <> "0" then Unsupported "boundaries"
    else if handles <> [] then Unsupported "handles"
    else if String.length word > max_symbols then Unsupported "max_symbols"
    else begin
      let letters = List.filter_map Fun.id letters in
      match Sphere.undone letters with
      | None -> reject "unfinished-word"
      | Some [] -> reject "empty-word"
      | Some [ _ ] ->
        (match Sphere.decode letters with
         | None -> reject ""
         | Some faces ->
           Ok
             (Printf.sprintf {|{"faces":[%s],"vertices":%d}|}
                (String.concat "," (List.map face faces))
                (largest_vertex faces + 1)))
      | Some trees ->
        if List.for_all (fun tree -> Sphere.len tree = 3) trees then Unsupported "components" else reject ""
    end
  | _ -> assert false

(* ** Encoding *)

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

let encode given =
  let faces, vertices = shape given in
  if List.length faces > max_symbols then Unsupported "max_faces"
  else
    match fault faces vertices with
    | Some answer -> answer
    | None ->
      (match Sphere.encode faces with
       | None -> failwith "a walk without an end"
       | Some (_, _ :: _) -> Unsupported "handles"
       | Some (steps, []) when List.length steps + 1 < List.length faces -> Unsupported "components"
       | Some (steps, []) ->
         let word = String.of_seq (List.to_seq (List.map (fun (s, _) -> letter_of s) steps)) in
         let order = List.map string_of_int (Sphere.order faces steps) in
         Ok
           (Printf.sprintf
              {|{"word":"%s","handles":[],"components_with_boundary":0,"vertex_order":[%s]}|} word
              (String.concat "," order)))
