package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/** The file bundles/LAYERS: lines of a level, for whom it is, and its bundles, lowest first. */
record Layers(List<Layer> layers) {

  private static final String FOR = "for";

  private static final String NOBODY = "none";

  private static final String OURS = "org.robotui.";

  /**
   * One line.
   *
   * @param level as written
   * @param users the levels that may import it: empty means all those below the line
   * @param patterns the names or patterns of its bundles
   */
  record Layer(String level, List<String> users, List<String> patterns) {

    boolean isFor(String other) {
      return users.isEmpty() || users.contains(other);
    }

    boolean isForNobody() {
      return users.equals(List.of(NOBODY));
    }

    String audience() {
      return isForNobody() ? "nobody" : String.join(" ", users) + " alone";
    }
  }

  static Layers read(Path file) {
    return parse(Trees.read(file));
  }

  static Layers parse(String text) {
    return new Layers(text.lines()
        .map(line -> line.replaceAll("#.*", "").strip())
        .filter(line -> !line.isEmpty())
        .map(Layers::layer)
        .toList());
  }

  /** How high a bundle stands, or nothing if no line names it. */
  OptionalInt height(String bundle) {
    return IntStream.range(0, layers.size())
        .filter(i -> layers.get(i).patterns().stream().anyMatch(pattern -> matches(pattern, bundle)))
        .findFirst();
  }

  Layer at(int height) {
    return layers.get(height);
  }

  static boolean matches(String pattern, String name) {
    return pattern.endsWith("*") ? name.startsWith(pattern.substring(0, pattern.length() - 1)) : name.equals(pattern);
  }

  private static Layer layer(String line) {
    List<String> words = Arrays.asList(line.split("\\s+"));
    int names = (int) words.stream().takeWhile(word -> !word.startsWith(OURS)).count();
    boolean limited = names > 1 && words.get(1).equals(FOR);
    return new Layer(words.getFirst(), limited ? words.subList(2, names) : List.of(),
        words.subList(names, words.size()));
  }
}
