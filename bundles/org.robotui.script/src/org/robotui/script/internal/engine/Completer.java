package org.robotui.script.internal.engine;

import java.util.Collection;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robotui.api.host.Arranging.ViewChoice;
import org.robotui.api.host.Host;
import org.robotui.api.host.Ruic;
import org.robotui.api.command.Authority;
import org.robotui.api.script.ScriptSession.Completion;

/**
 * What could stand at the end of a line.
 *
 * @param host knows robots, ports and views
 * @param words functions and variables
 */
record Completer(Host host, Collection<String> words) {
  /** Words of the language that are longer than what is typed of them. */
  static final String[] LANGUAGE = {"break", "continue", "const", "delete", "else", "false", "finally", "for",
      "function", "instanceof", "let", "new", "null", "return", "throw", "true", "try", "typeof", "undefined", "while",
      "Array", "JSON", "Math", "Number", "Object", "String"};
  private static final int MOST = 100;
  private static final Pattern NAME = Pattern.compile("(^|[^.\\w$])([A-Za-z_$][\\w$]*)$");

  Completion complete(String line) {
    int quote = openQuote(line);
    if (quote >= 0) {
      return completion(quote + 1, line.substring(quote + 1), names());
    }
    Matcher name = NAME.matcher(line);
    return name.find() ? completion(name.start(2), name.group(2), words.stream())
        : new Completion(line.length(), List.of());
  }

  private static Completion completion(int start, String typed, Stream<String> all) {
    return new Completion(start,
        all.filter(word -> word.startsWith(typed) && !word.equals(typed)).distinct().sorted().limit(MOST).toList());
  }

  /** Where a text begins that does not end in the line; -1 where none does. */
  private static int openQuote(String line) {
    int open = -1;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (open >= 0 && c == '\\') {
        i++;
      } else if (open >= 0 && c == line.charAt(open)) {
        open = -1;
      } else if (open < 0 && (c == '"' || c == '\'' || c == '`')) {
        open = i;
      }
    }
    return open;
  }

  private Stream<String> names() {
    return host.ruics().stream().flatMap(Completer::names);
  }

  private static Stream<String> names(Ruic ruic) {
    return Stream.of(Stream.of(ruic.name()), ruic.authorities().stream().map(Authority::robot),
        ruic.snapshot().ports().stream().map(p -> p.port().toString()),
        ruic.snapshot().components().stream().map(c -> c.id()),
        ruic.arranging().views().stream().map(ViewChoice::id), ruic.arranging().perspectives().keySet().stream())
        .flatMap(names -> names);
  }
}
