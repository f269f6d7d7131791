package org.robotui.carmen.message;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.robotui.carmen.format.IpcFormat;

/**
 * How a field is called, which IPC's formats do not say.
 *
 * @param name without blanks
 * @param unit such as {@code m/s}; empty where it has none or none is known
 * @param members how fields within it are called, where it is a structure or an array of such
 */
public record FieldName(String name, String unit, List<FieldName> members) {

  /** Copies the list. */
  public FieldName {
    members = List.copyOf(members);
  }

  /**
   * Reads names as {@code x[m] pose{x[m] y[m]} host}.
   *
   * @param text names with blanks between them
   * @return in their order
   * @throws IllegalArgumentException where braces do not match
   */
  public static List<FieldName> parse(String text) {
    String spaced = text.replace("{", " { ").replace("}", " } ").strip();
    List<String> words = spaced.isEmpty() ? List.of() : List.of(spaced.split("\\s+"));
    int[] at = {0};
    List<FieldName> names = parse(words, at);
    if (at[0] < words.size()) {
      throw new IllegalArgumentException("'" + text + "' closes more than it opens");
    }
    return names;
  }

  private static List<FieldName> parse(List<String> words, int[] at) {
    List<FieldName> names = new ArrayList<>();
    while (at[0] < words.size() && !words.get(at[0]).equals("}")) {
      String word = words.get(at[0]++);
      int unit = word.indexOf('[');
      List<FieldName> within = List.of();
      if (at[0] < words.size() && words.get(at[0]).equals("{")) {
        at[0]++;
        within = parse(words, at);
        if (at[0] == words.size()) {
          throw new IllegalArgumentException(word + " opens a brace that is not closed");
        }
        at[0]++;
      }
      names.add(unit < 0 ? new FieldName(word, "", within)
          : new FieldName(word.substring(0, unit), word.substring(unit + 1, word.length() - 1), within));
    }
    return names;
  }

  /**
   * Names for a format of which no names are known: {@code field1}, {@code field2} and so on.
   *
   * @param format of a message or a part
   * @return one for each member; one for what is no structure; none where there is nothing
   */
  static List<FieldName> numbered(IpcFormat format) {
    return switch (format) {
      case IpcFormat.Nothing n -> List.of();
      case IpcFormat.Struct s -> IntStream.range(0, s.members().size())
          .mapToObj(i -> new FieldName("field" + (i + 1), "", within(s.members().get(i)))).toList();
      default -> List.of(new FieldName("field1", "", within(format)));
    };
  }

  private static List<FieldName> within(IpcFormat format) {
    return switch (format) {
      case IpcFormat.Struct s -> numbered(s);
      case IpcFormat.Pointer p -> within(p.target());
      case IpcFormat.FixedArray a -> within(a.element());
      case IpcFormat.VariableArray a -> within(a.element());
      default -> List.of();
    };
  }

  /**
   * Whether names are those of a format, one for each member at all depths.
   *
   * @param names to be judged
   * @param format of the message
   * @return true where they fit
   */
  static boolean fit(List<FieldName> names, IpcFormat format) {
    return same(names, numbered(format));
  }

  private static boolean same(List<FieldName> some, List<FieldName> others) {
    return some.size() == others.size() && IntStream.range(0, some.size())
        .allMatch(i -> same(some.get(i).members(), others.get(i).members()));
  }
}
