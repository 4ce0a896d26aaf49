// An adapter to begin with: it does `echo`, and says so of nothing else.
//
// One request a line comes on standard input, one reply a line goes to standard output; print
// anything else to standard error. What the operations take and give: spec/09-conformance.md.
package main

import (
	"bufio"
	"bytes"
	"encoding/json"
	"log"
	"os"
)

const protocol = 1

type request struct {
	Op       string          `json:"op"`
	ID       json.RawMessage `json:"id"`
	Protocol int             `json:"protocol"`
	In       json.RawMessage `json:"in"`
	Trace    string          `json:"trace"`
}

type object map[string]any

var hello = object{
	"protocol": protocol,
	"name":     "my mesh library",
	"version":  "0.1",
	"language": "go",
	"ops":      []string{"echo"}, // then "word.decode", …
	"caps": object{
		"handles":     false,
		"boundaries":  "none", // or "one", or "many"
		"components":  false,
		"max_faces":   1000000,
		"max_symbols": 1000000,
	},
}

// answer gives the key of the reply, one of ok, reject, unsupported, error, and its value.
func answer(r request) (string, any) {
	switch {
	case r.Op == "hello" && r.Protocol != protocol:
		return "unsupported", object{"cap": "protocol"}
	case r.Op == "hello":
		return "ok", hello
	case r.Op == "echo":
		return "ok", r.In
	// Here your operations join. Bad input is
	//   "reject", object{"class": "malformed", "reason": "…"}    (or "invalid", "unsupported", "limit")
	default:
		return "unsupported", object{"cap": r.Op}
	}
}

func main() {
	in, out := bufio.NewReader(os.Stdin), bufio.NewWriter(os.Stdout)
	for {
		line, err := in.ReadBytes('\n')
		if err != nil || len(bytes.TrimSpace(line)) == 0 {
			return
		}
		var r request
		if err := json.Unmarshal(line, &r); err != nil {
			log.Fatal(err)
		}
		if r.Op == "bye" {
			return
		}
		key, value := answer(r)
		reply, err := json.Marshal(object{"id": r.ID, key: value})
		if err != nil {
			log.Fatal(err)
		}
		out.Write(reply)
		out.WriteByte('\n')
		out.Flush()
	}
}
