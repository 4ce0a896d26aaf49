/* An adapter to begin with: it does `echo`, and says so of nothing else.
 *
 * One request a line comes on standard input, one reply a line goes to standard output; print
 * anything else to standard error. What the operations take and give: spec/09-conformance.md.
 *
 * C has no JSON of its own. `find` gives the text of a value of an object, unread; that is enough
 * to begin with, as requests are well formed. For more than echo take a JSON library.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROTOCOL "1"

static const char HELLO[] =
    "{\"protocol\":" PROTOCOL ",\"name\":\"my mesh library\",\"version\":\"0.1\",\"language\":\"c\","
    "\"ops\":[\"echo\"]," /* then "word.decode", ... */
    "\"caps\":{\"handles\":false,\"boundaries\":\"none\",\"components\":false,"
    "\"max_faces\":1000000,\"max_symbols\":1000000}}";

/* A piece of a line. */
typedef struct {
    const char *start;
    size_t length;
} Text;

static const char *past_space(const char *at) {
    while (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\n') at++;
    return at;
}

static const char *past_string(const char *at) {
    for (at++; *at && *at != '"'; at++)
        if (*at == '\\' && at[1]) at++;
    return *at ? at + 1 : at;
}

static const char *past_value(const char *at) {
    int depth = 0;
    while (*at) {
        if (*at == '"') {
            at = past_string(at);
            if (depth == 0) return at;
            continue;
        }
        if (depth == 0 && (*at == ',' || *at == '}' || *at == ']')) return at;
        if (*at == '{' || *at == '[') depth++;
        if (*at == '}' || *at == ']') {
            if (--depth == 0) return at + 1;
        }
        at++;
    }
    return at;
}

/* The text of a key's value in an object; of length 0 if the key is not there. */
static Text find(const char *object, const char *key) {
    const char *at = past_space(object);
    Text none = {at, 0};
    if (*at == '{') at = past_space(at + 1);
    while (*at == '"') {
        const char *name = at + 1, *value;
        at = past_string(at);
        size_t length = (size_t)(at - name) - 1;
        value = past_space(past_space(at) + 1);
        at = past_value(value);
        if (length == strlen(key) && memcmp(name, key, length) == 0) {
            Text found = {value, (size_t)(at - value)};
            while (found.length && found.start[found.length - 1] <= ' ') found.length--;
            return found;
        }
        at = past_space(at);
        if (*at == ',') at = past_space(at + 1);
    }
    return none;
}

static int is(Text text, const char *wanted) {
    return text.length == strlen(wanted) && memcmp(text.start, wanted, text.length) == 0;
}

/* One of ok, reject, unsupported, error. */
static void answer(const char *request, Text operation) {
    if (is(operation, "\"hello\"") && !is(find(request, "protocol"), PROTOCOL)) {
        printf("\"unsupported\":{\"cap\":\"protocol\"}");
    } else if (is(operation, "\"hello\"")) {
        printf("\"ok\":%s", HELLO);
    } else if (is(operation, "\"echo\"")) {
        Text in = find(request, "in");
        printf("\"ok\":");
        fwrite(in.start, 1, in.length, stdout);
    } else {
        /* Before this your operations join. Bad input is
           "reject":{"class":"malformed","reason":"..."}  (or "invalid", "unsupported", "limit") */
        printf("\"unsupported\":{\"cap\":");
        fwrite(operation.start, 1, operation.length, stdout);
        printf("}");
    }
}

int main(void) {
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, stdin) > 0) {
        Text operation = find(line, "op"), id = find(line, "id");
        if (is(operation, "\"bye\"")) break;
        printf("{\"id\":");
        fwrite(id.start, 1, id.length, stdout);
        printf(",");
        answer(line, operation);
        printf("}\n");
        fflush(stdout);
    }
    free(line);
    return 0;
}
