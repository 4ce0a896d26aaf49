(* word.decode by the decoder that is proved, for one closed component without records: ORCL-OP-5. *)

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
